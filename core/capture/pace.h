// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <condition_variable>
#include <mutex>
#include <optional>

namespace odo {

/// Lets pictures out at their time. Without a pace (tests) they come as fast as they are asked for.
class Pace
{
public:
    enum class Kind { RealTime, None };
    using Start = std::optional<std::chrono::steady_clock::time_point>;
    /// start: where several are to keep step; otherwise it begins at the first call.
    explicit Pace(Kind kind, Start start = std::nullopt) : m_kind(kind), m_start(start) {}

    /// Waits until so much time has passed since the beginning. False once stopped.
    bool waitUntil(Nanoseconds time);
    /// How late it is by the clock; 0 without a pace. Call it after waitUntil.
    Nanoseconds lateness(Nanoseconds time) const;
    /// Any thread; wakes who waits.
    void stop();

private:
    const Kind m_kind;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    Start m_start;
    bool m_stopped = false;
};

} // namespace odo
