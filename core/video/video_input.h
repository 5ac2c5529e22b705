// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/video/libav.h"

#include <filesystem>

namespace odo {

/// One local file opened by libav's demuxer, giving the packets of its first real video stream. The file is
/// opened by us, only ordinary containers may be recognised in it, and the demuxer is refused every other
/// file, so a playlist or a reference inside the file leads nowhere. Not thread-safe.
class VideoInput
{
public:
    /// cancel: once it is cancelled, read() ends with AVERROR_EXIT. Errors: missing, a folder or device, unreadable, not a video, no video stream.
    static Result<std::unique_ptr<VideoInput>> open(const std::filesystem::path &file, const CancelToken &cancel = {});
    /// The same file from its beginning, taken for the container that it was found to be.
    Result<std::unique_ptr<VideoInput>> openedAgain() const;
    ~VideoInput();
    VideoInput(const VideoInput &) = delete;
    VideoInput &operator=(const VideoInput &) = delete;

    const std::filesystem::path &file() const { return m_file; }
    bool isCancelled() const { return m_cancel.isCancelled(); }
    const AVFormatContext &container() const { return *m_container; }
    const AVStream &stream() const { return *m_stream; }
    /// Chroma location that the container itself states; the parameters of the stream hold what the decoder
    /// assumed.
    AVChromaLocation containerChromaLocation() const { return m_containerChromaLocation; }

    /// The next packet of the video stream. 0, AVERROR_EOF or another error of libav.
    int read(AVPacket &packet);
    /// Latest end of any packet of any stream read so far, in AV_TIME_BASE units since the container's start.
    std::int64_t lastEnd() const { return m_lastEnd; }
    /// Asks the demuxer to go to the key frame at or before this time stamp of the stream. Where it really
    /// went is only known from the next packet.
    bool seek(std::int64_t timeStamp);

private:
    VideoInput(std::filesystem::path file, CancelToken cancel) : m_file(std::move(file)), m_cancel(std::move(cancel)) {}
    static Result<std::unique_ptr<VideoInput>> open(const std::filesystem::path &file, const AVInputFormat *known, const CancelToken &cancel);
    Result<void> openContainer(const AVInputFormat *known);
    Result<void> findStream();

    std::filesystem::path m_file;
    CancelToken m_cancel;
    AVIOContext *m_io = nullptr;
    AVFormatContext *m_container = nullptr;
    AVStream *m_stream = nullptr;
    AVChromaLocation m_containerChromaLocation = AVCHROMA_LOC_UNSPECIFIED;
    std::int64_t m_lastEnd = 0;
};

} // namespace odo
