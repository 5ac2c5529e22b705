// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

namespace odo {

/// The way that a run took, as a reference path for others: its smoothed places from the onset of motion to
/// the last stop, at least 5 mm apart, straight across gaps. A run that comes back to where it began, in the
/// same direction, has driven a closed path, of which the first lap is taken. Without points when the robot
/// never moves by as much.
ReferencePath pathOfRun(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points);

/// The path driven the other way; a closed one begins at the same point.
ReferencePath reversed(ReferencePath path);

/// How far the points of a path lie apart at most: the diagonal of the box round them.
double extentOf(const ReferencePath &path);

} // namespace odo
