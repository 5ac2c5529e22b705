// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/video/frame.h"
#include "core/video/frame_times.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// What a video file says of itself, and what a walk over its packets found.
struct VideoInfo
{
    FrameFormat format;
    std::string codec;                   ///< libav's name, e.g. "h264"
    int bitDepth = 8;                    ///< of the samples as coded; those of frames have 8 bits
    std::vector<Nanoseconds> frameTimes; ///< presentation times since the first frame, strictly increasing
    double framesPerSecond = 0; ///< 1 / typical interval (mean of those near the median); 0 for one frame
    bool variableRate = false;  ///< intervals differ by more than 10 % of the median
    Nanoseconds duration{0};    ///< last frame time − first frame time + typical interval
    /// Frames a second at which the camera took them, where the file says so besides (Android's capture
    /// rate); of slow motion and time lapse it is not that of the times.
    std::optional<double> capturedPerSecond;
    TimeSource timeSource = TimeSource::Stamps; ///< of the times and all that follows from them
    /// How long after the first frame the file's clock starts again, as where two files were joined: the
    /// frames that follow are stamped as if they came before, and all of them are sorted by their stamps. Or
    /// the stamps stand still there, as editors write them then.
    std::optional<Nanoseconds> restartsAt;
    /// The coded frames hold two fields, taken one after the other, and the frames given here are these
    /// fields, at half the vertical resolution, in the order in which they were taken. frameTimes has both;
    /// the rate is that of coded frames.
    bool areFields = false;
    /// How the stored frames were turned (frame_turn.h) to be those given here: as the container's display
    /// matrix says, or as the project knows that they were measured.
    int orientation = 1;
    Message warning; ///< empty, or such as "ends early at 12.40 s: …" of a truncated file
};

/// What a project knows of a recording that it has measured, whatever readers take its file for today.
struct KnownRecording
{
    std::size_t frames = 0;         ///< 0: not known
    std::optional<int> orientation; ///< by which its frames were turned; none: as the file says
    int widthPx = 0, heightPx = 0;  ///< of its frames; 0: as the file says
};

/// Decodes one local video file to planes of 8 bits, with the code values of the file (of interlaced ones
/// field by field) but as a person sees it: turned as the container says, and stretched where its pixels are
/// not square, unless the project knows that its frames were measured as stored. Frame-accurate; MJPEG by
/// libjpeg-turbo, all else by libavcodec. Only ordinary container formats and the file protocol are allowed,
/// so that a playlist dressed up as a video cannot open another file. Not thread-safe: one thread at a time
/// uses a reader. See FrameStream for reading ahead on its own thread.
class VideoReader
{
public:
    /// Opens the file and indexes its packets. Errors: missing file, not a video, unsupported
    /// pixel format, no video stream. cancel: ends this, and every later search for a frame, with Cancelled;
    /// a large file on a slow disk takes its time. known: of the file, as a project has it. Of a file that
    /// says it is interlaced the first frames are decoded to see whether and in which order it is
    /// (FieldMotion), unless the project counts its frames whole: then they are given so. Of any other the
    /// same if the project counts two for each.
    static Result<std::unique_ptr<VideoReader>>
    open(const std::filesystem::path &file, const CancelToken &cancel = {}, const KnownRecording &known = {});
    ~VideoReader();
    VideoReader(const VideoReader &) = delete;
    VideoReader &operator=(const VideoReader &) = delete;

    /// Whether a file without time stamps states no frame rate either (TimeSource::Nowhere), from its
    /// headers alone. False also where it cannot be opened.
    static bool lacksTimes(const std::filesystem::path &file);
    /// Whether a file says, in its headers, that its frames are to be shown otherwise than a project knows
    /// that they were measured. False also where it cannot be opened.
    static bool isShownOtherwise(const std::filesystem::path &file, const KnownRecording &known);

    const VideoInfo &info() const;
    /// The next frame in order of presentation; nullopt at the end. A damaged frame is an Error that can be
    /// skipped by calling again (InvalidInput; Unavailable where memory ran out). A region asks for no more
    /// than this part; where decodesRegions() the frame may then hold only that (Frame::validRegion), in all
    /// else it is whole.
    Result<std::optional<Frame>> next(const std::optional<PixelRect> &region = std::nullopt);
    /// Whether asking for a region saves time: in MJPEG that is neither turned nor stretched it does.
    bool decodesRegions() const;
    /// Makes next() give the frame of this index. Exact for every codec: seeks to a key frame before it and
    /// decodes on.
    Result<void> seek(std::int64_t frameIndex);
    /// The key frame from which a frame is decoded: itself, or one before it. Reads nothing.
    std::int64_t keyFrameBefore(std::int64_t frameIndex) const;
    /// seek and next; reading in order costs no seek.
    Result<Frame> frameAt(std::int64_t frameIndex);

private:
    struct Impl;
    explicit VideoReader(std::unique_ptr<Impl> impl);
    static Result<std::unique_ptr<VideoReader>>
    openChecked(const std::filesystem::path &file, const CancelToken &cancel, const KnownRecording &known);
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
