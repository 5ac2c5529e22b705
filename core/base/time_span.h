// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

namespace odo {

/// A stretch of time, both ends included; begin ≤ end.
struct TimeSpan
{
    Nanoseconds begin{0}, end{0};

    bool contains(Nanoseconds time) const { return time >= begin && time <= end; }
    bool operator==(const TimeSpan &) const = default;
};

} // namespace odo
