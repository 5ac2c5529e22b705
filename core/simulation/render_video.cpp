// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/renderer.h"

namespace odo {

Result<void> renderVideo(const SimulatedScene &scene, int camera, const OutputTarget &target,
                         const VideoWriterOptions &options, const JobControl &control)
{
    const std::filesystem::path &file = target.file;
    SceneRenderer renderer(scene, camera);
    const std::int64_t count = renderer.frameCount();
    if (count == 0)
        return fail(ErrorCode::InvalidInput, "cannot render " + file.string(),
                    "camera " + scene.cameras[static_cast<std::size_t>(camera)].name +
                        " takes no frame while the scene lasts",
                    "give the scene a longer duration or start the camera earlier");
    std::unique_ptr<VideoWriter> writer;
    for (std::int64_t i = 0; i < count; ++i) {
        if (control.isCancelled())
            return cancelled("rendering " + file.string());
        const Frame frame = renderer.render(i);
        if (!writer) {
            auto created = VideoWriter::create(target, frame.format, options);
            if (!created)
                return tl::unexpected(created.error());
            writer = std::move(*created);
        }
        if (auto written = writer->write(frame); !written)
            return written;
        control.report(static_cast<double>(i + 1) / static_cast<double>(count),
                       "rendering " + file.filename().string());
    }
    return writer->finish();
}

} // namespace odo
