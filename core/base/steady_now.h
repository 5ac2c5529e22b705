// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

namespace odo {

/// How long the machine has slept since it was started: by so much steadyNow() is ahead of
/// std::chrono::steady_clock, which stops meanwhile and by which Linux's drivers stamp frames. In a
/// file of its own, so that a test can have the machine sleep by defining it itself. Any thread.
Nanoseconds machineSlept();

/// This machine's steady clock, the common time of all cameras' frames. It is never set, and goes on while
/// the machine sleeps, as the cameras' own clocks do. Not the clock that condition variables wait by: wait
/// for a length of time. Any thread.
inline Nanoseconds steadyNow()
{
    return std::chrono::steady_clock::now().time_since_epoch() + machineSlept();
}

} // namespace odo
