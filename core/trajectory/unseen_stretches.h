// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <string>
#include <vector>

namespace odo {

/// A sentence for every stretch, after the robot was first seen, in which no view saw it for so long that the
/// profile has nothing there: between sightings longer than a gap that is bridged, or over half a second at
/// the end. It says when and where the robot left and what to do. Without subject, to be put behind
/// "robot R: ".
std::vector<std::string> describeUnseenStretches(const Profile &profile, Nanoseconds longestBridgedGap);

} // namespace odo
