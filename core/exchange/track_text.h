// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <string>

namespace odo {

/// Tracks for other programs: only the points where the profile is valid, metres and seconds, the same bytes
/// in every locale.

/// TUM, as evo reads it: "timestamp tx ty tz qx qy qz qw" with single blanks and none at the end of a line; z
/// = 0 and a rotation about Z only: the direction of motion, kept while the robot is slower than three σ of
/// its speed.
std::string trackTum(const AnalysisRecord &analysis);

/// Text that Tracker (Open Source Physics) imports as a data track: the robot's name, then columns t, x, y
/// with tabs.
std::string trackTracker(const AnalysisRecord &analysis);

} // namespace odo
