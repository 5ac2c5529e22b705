// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/file_source.h"

#include "core/base/steady_now.h"
#include "core/video/video_reader.h"

namespace odo {

namespace {

class FileSource : public CameraSource
{
public:
    FileSource(std::unique_ptr<VideoReader> reader, CameraDescription description, Pace::Kind pace)
        : m_reader(std::move(reader)), m_description(std::move(description)), m_pace(pace)
    {
    }
    const CameraDescription &description() const override { return m_description; }
    void stop() override { m_pace.stop(); }

    Result<CapturedFrame> next() override
    {
        auto frame = m_reader->next();
        if (!frame)
            return tl::unexpected(frame.error());
        if (!*frame)
            return fail(ErrorCode::Io, m_description.uri, "the video has ended", "open it again to see it from the start");
        if (!m_pace.waitUntil((*frame)->time))
            return cancelled(m_description.uri);
        CapturedFrame captured{std::move(**frame), 0, steadyNow()};
        captured.sequence = static_cast<std::uint64_t>(captured.frame.index);
        return captured;
    }

private:
    std::unique_ptr<VideoReader> m_reader;
    CameraDescription m_description;
    Pace m_pace;
};

} // namespace

Result<std::unique_ptr<CameraSource>> openFileSource(const std::filesystem::path &file, Pace::Kind pace)
{
    auto reader = VideoReader::open(file);
    if (!reader)
        return tl::unexpected(reader.error());
    const VideoInfo &info = (*reader)->info();
    CameraDescription description{"file:" + file.string(), "file", file.filename().string(), info.format.width,
                                  info.format.height, info.framesPerSecond};
    return std::make_unique<FileSource>(std::move(*reader), std::move(description), pace);
}

} // namespace odo
