// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <Eigen/Core>

namespace odo {

/// Upright boxes and cylinders; wheels are cylinders that lie across the robot.
enum class SimulatedShape { Box, Cylinder, Wheel, Sphere };

/// A convex solid that a robot is made of. Robot's frame: x forward, y to the left, z up from the floor; the origin is the
/// centre of the footprint's bounding rectangle. The parts of a robot share no volume.
struct RobotPart
{
    SimulatedShape shape = SimulatedShape::Box;
    RgbColour colour;
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero();
    Eigen::Vector3d sizeM = Eigen::Vector3d::Zero(); ///< along x, y, z; of round ones the diameters are equal

    Eigen::Vector3d lower() const { return centreM - sizeM / 2; }
    Eigen::Vector3d upper() const { return centreM + sizeM / 2; }
};

} // namespace odo
