// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bounded_queue.h"
#include "core/capture/camera_source.h"
#include "core/capture/internal/view_writer.h"

#include <atomic>
#include <future>
#include <thread>
#include <variant>

namespace odo {

/// Codes the pictures of one camera on a thread of its own, keeps the last seconds of them, and hands them to
/// a writer when there is one. Any thread, but for start() and end().
class ViewCoder
{
public:
    struct Picture
    {
        CapturedFrame captured;
        Nanoseconds taken;
        std::optional<Error> interruption; ///< what kept the camera from delivering just before
        std::uint64_t lostBefore;          ///< that came, and found no room on the way to the coder
    };

    /// uri: of the camera. preRoll: how much is kept while nothing is written.
    ViewCoder(std::string uri, Nanoseconds preRoll);
    ~ViewCoder(); ///< after end(), where start() succeeded
    ViewCoder(const ViewCoder &) = delete;
    ViewCoder &operator=(const ViewCoder &) = delete;

    /// Unavailable where there is no thread; then whatever is to be written ends at once.
    Result<void> start();
    /// Never waits; false: there is no room.
    bool offer(Picture picture);
    /// From now on all goes to the writer, beginning with what arrived then.
    void startWriting(std::shared_ptr<ViewWriter> writer, Nanoseconds from);
    /// When what was offered by now was handed to the writer and it was closed. lostBefore: what found no
    /// room since the last picture.
    std::future<void> stopWriting(std::uint64_t lostBefore);
    /// What was offered is still coded; waits for that.
    void end();

    /// What the pictures take on the disk, as they come now; 0 while that is not known.
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
    using Work = std::variant<Picture, Start, Stop>;
    struct Coding;

    void run();
    void code(Coding &coding, const Picture &picture);

    const std::string m_uri;
    const Nanoseconds m_preRoll;
    BoundedQueue<Work> m_work;
    std::thread m_thread;
    std::atomic<double> m_bytesPerSecond = 0; ///< of what is kept
};

} // namespace odo
