// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/output_file.h"
#include "core/video/frame.h"

#include <filesystem>
#include <memory>

namespace odo {

enum class VideoCodec { H264, Mjpeg, Ffv1 };

struct VideoWriterOptions
{
    VideoCodec codec = VideoCodec::H264;
    double nominalFramesPerSecond =
        30;                  ///< for rate control and players; the frames' own times are what is written
    int bitRate = 8'000'000; ///< H264 only, bits a second
    int mjpegQuality = 3;    ///< libav's qscale, 2 (best) to 31
    int threads = 1;         ///< of the encoder; 1: the same bytes on every machine, 0: as many as it likes
    int maxBFrames = 0;      ///< H264 in MP4 only: frames that are coded out of order
};

/// Of a video of that name: Matroska where it ends with .mkv, else MP4.
FileKind videoKind(const std::filesystem::path &file);

/// Writes frames with their exact times (variable rate allowed, microseconds, counted from the first frame)
/// to a file that appears under its name only when finish() succeeded (OutputFile). The ending decides the
/// container: .mkv or .mp4 (not for FFV1). The same frames and options give the same bytes on every machine
/// (with one thread). Not thread-safe.
class VideoWriter
{
public:
    /// Errors: unknown ending, those of OutputFile, a format that the codec cannot take (H264
    /// needs an even size).
    static Result<std::unique_ptr<VideoWriter>> create(const OutputTarget &target, const FrameFormat &format,
                                                       const VideoWriterOptions &options);
    /// Matroska in an empty file whose name was claimed, and that whoever did so removes where this fails.
    static Result<std::unique_ptr<VideoWriter>> createClaimed(const std::filesystem::path &claimed,
                                                              const FrameFormat &format,
                                                              const VideoWriterOptions &options);
    ~VideoWriter(); ///< without finish(): removes the partial file
    VideoWriter(const VideoWriter &) = delete;
    VideoWriter &operator=(const VideoWriter &) = delete;

    /// Times must increase by at least a microsecond. The frame's format must be the one given to create.
    Result<void> write(const Frame &frame);
    Result<void> finish();

private:
    struct Impl;
    explicit VideoWriter(std::unique_ptr<Impl> impl);
    static Result<std::unique_ptr<Impl>>
    prepared(const std::filesystem::path &file, const FrameFormat &format, const VideoWriterOptions &options);
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
