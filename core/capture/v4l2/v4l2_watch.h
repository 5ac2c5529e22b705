// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>

namespace odo {

/// What a source waits for: a picture, a camera that is plugged in (a change in /dev; where that cannot be
/// watched, the end of the wait stands for it), or being stopped.
class V4l2Watch
{
public:
    V4l2Watch();
    ~V4l2Watch();
    V4l2Watch(const V4l2Watch &) = delete;
    V4l2Watch &operator=(const V4l2Watch &) = delete;

    /// Waits until the camera has something to say; below 0: until nodes change. False when the camera says
    /// that it is broken.
    bool wait(int camera, std::chrono::steady_clock::time_point until);
    /// For good. Any thread.
    void stop();
    bool isStopped() const { return m_stopped; }

private:
    void forgetChanges() const;

    int m_wake = -1, m_nodes = -1;
    std::atomic<bool> m_stopped = false;
};

} // namespace odo
