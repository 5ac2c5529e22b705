// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>

namespace odo {

class AravisDevice;

/// What the thread of a camera and those who use it share. Any thread.
class AravisSession
{
public:
    /// Work for the camera's thread; gets nullptr while there is no camera.
    using Task = std::function<void(AravisDevice *)>;

    explicit AravisSession(std::string uri) : m_uri(std::move(uri)) {}

    // Who uses the camera:
    Result<CapturedFrame> next(Nanoseconds patience);
    CameraCounts counts() const;
    void stop();
    void ask(Task task);
    /// False when it has not ended by then.
    bool waitForEnd(Nanoseconds patience);

    // The camera's thread:
    bool isStopped() const;
    void deliver(CapturedFrame frame);
    /// Why no frames come; returned with the next failure of next().
    void setProblem(Error error);
    void count(const CameraCounts &counts);
    void runTasks(AravisDevice *device);
    /// Does what is asked meanwhile; returns early when it is stopped.
    void waitWithoutCamera(Nanoseconds howLong);
    void end();

private:
    const std::string m_uri;
    mutable std::mutex m_mutex;
    std::condition_variable m_forUser, m_forCamera;
    std::deque<CapturedFrame> m_frames;
    std::deque<Task> m_tasks;
    std::optional<Error> m_problem;
    CameraCounts m_counts;
    bool m_stopped = false, m_ended = false;
};

} // namespace odo
