// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace odo {

/// How a course is driven.
struct CourseDriving
{
    double speedMps = 1;   ///< steady speed; less in tight curves and on short lines
    double rampS = 0.7;    ///< from rest to that speed, and back to rest
    double pauseS = 0.6;   ///< of each stop, before the start and after the end too
    double accelMps2 = 2;  ///< the most in curves
    double longestM = 1e9; ///< where it ends though the course goes on
};

/// A course as it is driven.
struct CourseRun
{
    std::shared_ptr<const Motion> motion;
    double durationS = 0;                 ///< with the pause at its end
    double lengthM = 0, topSpeedMps = 0;  ///< of all of it
    std::vector<Eigen::Vector2d> corners; ///< where it starts, stops and ends
};

/// Drives through these points in their order. Where the line turns by more than 20° it stops and turns on
/// the spot; between such corners it follows a twice continuously differentiable curve through the line. At
/// least two points apart from each other.
CourseRun driveCourse(const std::vector<Eigen::Vector2d> &points, const CourseDriving &driving);

} // namespace odo
