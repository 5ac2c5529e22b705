// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

namespace odo {

/// What a project may hold: refused where it is entered, and where a file holds more, the rest is not read.
/// docs/limits.md lists them with those defined elsewhere (isOnFloor, checkTask, maxBlobRows).

/// In characters of Unicode.
constexpr int maxNameLength = 200, maxTextLength = 20'000;
/// No quantity of ours is larger.
constexpr double largestNumber = 1e12;
/// A stored number as it is read; 0 for what is no number, which only another program can have written.
constexpr double bounded(double value)
{
    return value >= -largestNumber ? std::min(value, largestNumber) : value < 0 ? -largestNumber : 0;
}
constexpr std::size_t mostViews = 16, mostRobots = 32, mostTags = 50; ///< of a trial
constexpr std::size_t mostMarkers = 1000;                             ///< of a layout
constexpr int largestRobotM = 10;
/// Frames a second that a camera may be said to have taken.
constexpr double lowestFrameRate = 0.1, highestFrameRate = 100'000;
/// The largest time offset that may be given between two views or runs.
constexpr double largestOffsetS = 3600;

} // namespace odo
