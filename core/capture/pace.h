// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <condition_variable>
#include <mutex>

namespace odo {

/// Lets pictures out at their time. Without a pace (tests) they come as fast as they are asked for.
class Pace
{
public:
    enum class Kind { RealTime, None };
    explicit Pace(Kind kind) : m_kind(kind) {}

    /// Waits until so much time has passed since the first call. False once stopped.
    bool waitUntil(Nanoseconds time);
    /// How late it is by the clock; 0 without a pace. Call it after waitUntil.
    Nanoseconds lateness(Nanoseconds time) const;
    /// Any thread; wakes who waits.
    void stop();

private:
    const Kind m_kind;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::chrono::steady_clock::time_point m_start{};
    bool m_started = false, m_stopped = false;
};

} // namespace odo
