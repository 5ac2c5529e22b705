// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bounded_queue.h"
#include "core/capture/camera_source.h"
#include "core/capture/internal/view_writer.h"

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <variant>

namespace odo {

/// How much is kept while nothing is written.
struct KeptFrames
{
    Nanoseconds length;
    std::size_t mostBytes; ///< coded; beyond it the oldest are dropped
};

/// Codes the frames of one camera on a thread of its own, keeps the last seconds of them, and hands them to
/// a writer when there is one. Any thread, but for start() and end().
class ViewCoder
{
public:
    struct UncodedFrame
    {
        CapturedFrame captured;
        Nanoseconds taken;
        std::optional<Error> interruption; ///< what kept the camera from delivering just before
        std::uint64_t lostBefore;          ///< that came while the queue to the coder was full
    };

    /// uri: of the camera.
    ViewCoder(std::string uri, KeptFrames kept);
    ~ViewCoder(); ///< after end(), where start() succeeded
    ViewCoder(const ViewCoder &) = delete;
    ViewCoder &operator=(const ViewCoder &) = delete;

    /// Unavailable where there is no thread; then whatever is to be written ends at once.
    Result<void> start();
    /// Never waits; false: the queue is full.
    bool offer(UncodedFrame uncoded);
    void keepFor(Nanoseconds length) { m_keptFor = length; }
    /// From now on all goes to the writer, beginning with what arrived then.
    void startWriting(std::shared_ptr<ViewWriter> writer, Nanoseconds from);
    /// When what was offered by now was handed to the writer and it was closed. lostBefore: what was lost
    /// since the last frame because the queue was full.
    std::future<void> stopWriting(std::uint64_t lostBefore);
    /// What was offered is still coded; waits for that.
    void end();

    /// Bytes per second of the frames on the disk at present; 0 while that is not known.
    double bytesPerSecond() const { return m_bytesPerSecond; }

private:
    struct Start
    {
        std::shared_ptr<ViewWriter> writer;
        Nanoseconds from;
    };
    struct Stop
    {
        std::promise<void> done;
        std::uint64_t lostBefore;
    };
    using Work = std::variant<UncodedFrame, Start, Stop>;
    struct Coding;

    void run();
    void code(Coding &coding, const UncodedFrame &uncoded);

    const std::string m_uri;
    const std::size_t m_mostKeptBytes;
    std::atomic<Nanoseconds> m_keptFor;
    BoundedQueue<Work> m_work;
    std::thread m_thread;
    std::atomic<double> m_bytesPerSecond = 0; ///< of what is kept
};

} // namespace odo
