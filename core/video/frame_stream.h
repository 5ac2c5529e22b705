// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/video_reader.h"

#include <memory>
#include <optional>

namespace odo {

/// Reads one video from its first frame to its last on its own thread, a few frames ahead of the consumer,
/// through a bounded queue; or, when the consumer knows which part of the next frame it needs, on demand in
/// the consumer's own. Destroying it stops the thread. pop() is called from one thread.
class FrameStream
{
public:
    /// `ahead`: frames kept ready at most. known and errors: those of VideoReader::open.
    static Result<std::unique_ptr<FrameStream>> open(const std::filesystem::path &file, std::size_t ahead = 8,
                                                     const CancelToken &cancel = {},
                                                     const KnownRecording &known = {});
    /// Takes over a reader. With `ahead` 0 there is no thread: pop() decodes, and only the region that it
    /// receives.
    explicit FrameStream(std::unique_ptr<VideoReader> reader, std::size_t ahead);
    ~FrameStream();
    FrameStream(const FrameStream &) = delete;
    FrameStream &operator=(const FrameStream &) = delete;

    const VideoInfo &info() const;
    /// The next frame; nullopt at the end. Waits for the reading thread. Damaged frames are left out.
    /// A stream that reads ahead cannot heed the region: its frames are whole.
    Result<std::optional<Frame>> pop(const std::optional<PixelRect> &region = std::nullopt);
    /// CPU time that reading has taken so far, on whatever thread.
    Nanoseconds decodeCpuTime() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
