// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace odo {

/// A measured heading of a body. Seconds, radians.
struct TimedHeading
{
    double timeS = 0, radians = 0;
};

/// Indices of as many headings as one body can have had one after another, in order. From one to the next it
/// turns on as it did around one of them, but for what headings scatter and a robot's start of a turn; where
/// others between them are left out, by little. So an outline that shows a wrong side for some frames does
/// not count. Empty where more than three in ten would have to be left out: then the outlines show no heading
/// reliably. headings: in order of time. Pure; linear in their number.
std::vector<std::size_t> headingsInSequence(const std::vector<TimedHeading> &headings);

} // namespace odo
