// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/video_reader.h"

#include <memory>
#include <optional>

namespace odo {

/// Reads one video from its first frame to its last on its own thread, a few frames ahead of the consumer,
/// through a bounded queue. Destroying it stops the thread. pop() is called from one thread.
class FrameStream
{
public:
    /// `ahead`: frames kept ready at most. Errors: those of VideoReader::open.
    static Result<std::unique_ptr<FrameStream>> open(const std::filesystem::path &file,
                                                     std::size_t ahead = 8);
    ~FrameStream();
    FrameStream(const FrameStream &) = delete;
    FrameStream &operator=(const FrameStream &) = delete;

    const VideoInfo &info() const;
    /// The next frame; nullopt at the end. Waits for the reading thread. Damaged frames are skipped and
    /// counted.
    Result<std::optional<Frame>> pop();
    std::int64_t damagedFrames() const;
    /// CPU time that the reading thread has spent so far.
    Nanoseconds decodeCpuTime() const;

private:
    struct Impl;
    explicit FrameStream(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
