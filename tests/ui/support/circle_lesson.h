// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace odo {
class Project;
}

namespace odo::test {

/// What the simulated cameras' robot drives: a circle about the middle of the floor.
constexpr double circleRadiusM = 0.75;
inline const Eigen::Vector2d circleMiddle(1.5, 1.1);

/// Puts into a new project what a lesson with the simulated cameras needs: the floor that they see, both
/// registered to it, the robot that drives there, the teams Falcon and Otter, and the task "Circle" with its
/// gate.
void addCircleLesson(Project &project);

} // namespace odo::test
