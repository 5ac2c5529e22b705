// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/live/jpeg_camera.h"

#include "core/base/steady_now.h"
#include "core/capture/internal/stand_in_source.h"
#include "core/capture/v4l2/internal/v4l2_mode.h"
#include "core/simulation/renderer.h"
#include "core/video/jpeg.h"
#include "tests/support/said_error.h"

#include <linux/videodev2.h>

namespace odo::test {

namespace {

constexpr int webcamQuality = 85;

class JpegCamera : public CameraSource
{
public:
    JpegCamera(CameraDescription description, const v4l2_pix_format &format, JpegFrames frames)
        : m_description(std::move(description)), m_reader(format), m_frames(std::move(frames)),
          m_pace(Pace::Kind::RealTime)
    {
    }
    const CameraDescription &description() const override { return m_description; }
    void stop() override { m_pace.stop(); }

    Result<CapturedFrame> next() override
    {
        const Nanoseconds time = fromSeconds(static_cast<double>(m_next) / m_description.framesPerSecond);
        if (!m_pace.waitUntil(time))
            return test::saidFailure(ErrorCode::Cancelled, m_description.uri, "it was stopped",
                                     "open it again");
        auto image = m_reader.read((*m_frames)[m_next % m_frames->size()]);
        if (!image)
            return test::saidFailure(ErrorCode::Io, m_description.uri, "a picture is damaged",
                                     "look at how it was coded");
        CapturedFrame captured{std::move(image->frame), m_next++, steadyNow(), std::move(image->jpeg)};
        captured.frame.index = static_cast<std::int64_t>(captured.sequence);
        captured.frame.time = time;
        return captured;
    }

private:
    const CameraDescription m_description;
    V4l2Frames m_reader;
    const JpegFrames m_frames;
    Pace m_pace;
    std::uint64_t m_next = 0;
};

} // namespace

Result<JpegFrames> codeFrames(const SimulatedScene &scene, int camera, std::int64_t firstFrame)
{
    SceneRenderer renderer(scene, camera);
    JpegEncoder encoder(webcamQuality);
    auto frames = std::make_shared<std::vector<std::vector<std::uint8_t>>>();
    for (std::int64_t i = firstFrame; i < renderer.frameCount(); ++i) {
        auto jpeg = encoder.encode(renderer.render(i));
        if (!jpeg)
            return tl::unexpected(jpeg.error());
        frames->push_back(std::move(*jpeg));
    }
    return frames;
}

std::unique_ptr<CameraSource> openJpegCamera(const std::string &uri, JpegFrames frames,
                                             double framesPerSecond)
{
    const auto frame = jpegFormat(frames->front());
    v4l2_pix_format format{};
    format.pixelformat = V4L2_PIX_FMT_MJPEG;
    format.width = static_cast<unsigned>(frame->width);
    format.height = static_cast<unsigned>(frame->height);
    CameraDescription description{uri,          "simulated",   foreignWords("webcam"),
                                  frame->width, frame->height, framesPerSecond};
    return std::make_unique<JpegCamera>(std::move(description), format, std::move(frames));
}

} // namespace odo::test
