// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/frame.h"

#include <filesystem>
#include <memory>

namespace odo {

enum class VideoCodec { H264, Mjpeg, Ffv1 };

struct VideoWriterOptions
{
    VideoCodec codec = VideoCodec::H264;
    double nominalFramesPerSecond = 30; ///< for rate control and players; the frames' own times are what is written
    int bitRate = 8'000'000;            ///< H264 only, bits a second
    int mjpegQuality = 3;               ///< libav's qscale, 2 (best) to 31
};

/// Writes frames with their exact times (variable rate allowed, microsecond time base in Matroska) to a file that
/// appears under its name only when finish() succeeded: it is written beside it as ".part" first.
/// Not thread-safe.
class VideoWriter
{
public:
    static Result<std::unique_ptr<VideoWriter>> create(const std::filesystem::path &file, const FrameFormat &format,
                                                       const VideoWriterOptions &options);
    ~VideoWriter(); ///< without finish(): removes the partial file
    VideoWriter(const VideoWriter &) = delete;
    VideoWriter &operator=(const VideoWriter &) = delete;

    /// Times must increase strictly. The frame's format must be the one given to create.
    Result<void> write(const Frame &frame);
    Result<void> finish();

private:
    struct Impl;
    explicit VideoWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
