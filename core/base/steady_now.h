// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/platform/machine_sleep.h"

namespace odo {

/// This machine's steady clock, the common time of all cameras' frames. It is never set, and goes on while
/// the machine sleeps, as the cameras' own clocks do: so it is ahead of std::chrono::steady_clock, by which
/// Linux's drivers stamp frames, by what the machine slept. Not the clock that condition variables wait by:
/// wait for a length of time. Any thread.
inline Nanoseconds steadyNow()
{
    return std::chrono::steady_clock::now().time_since_epoch() + machineSlept();
}

} // namespace odo
