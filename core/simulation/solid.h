// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/robot_part.h"

#include <vector>

namespace odo {

/// A flat convex face, corners in order, anticlockwise seen from outside.
struct SolidFace
{
    std::vector<Eigen::Vector3d> corners;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< outward

    bool isSeenFrom(const Eigen::Vector3d &place) const { return normal.dot(place - corners.front()) > 0; }
};

/// The faces of a part, in the robot's frame. Round ones are regular prisms of the circle's area (cylinderSides); a sphere, of
/// which one sees a disc from anywhere, is the disc that a camera at this place sees.
std::vector<SolidFace> facesOf(const RobotPart &part, const Eigen::Vector3d &cameraInRobot);

/// The base of an upright part, or the outline of any other seen from above; anticlockwise.
std::vector<Eigen::Vector2d> outlineFromAbove(const RobotPart &part);

/// The sides of a regular prism that stands for a cylinder.
constexpr int cylinderSides = 96;

} // namespace odo
