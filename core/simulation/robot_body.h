// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/rgb_picture.h"
#include "core/simulation/scene.h"

#include <vector>

namespace odo {

/// A flat face of a body, convex, corners in order, world frame, with its shaded colour.
struct BodyFace
{
    std::vector<Eigen::Vector3d> corners;
    Rgb colour;
};

/// The faces of a robot that a camera can see; they do not overlap in its picture. The top has the robot's
/// colour, the sides the same hue, darker, depending on where they face.
std::vector<BodyFace> visibleFaces(const SimulatedRobot &robot, const MotionState &state,
                                   const Eigen::Vector3d &cameraInWorld);

/// The robot's footprint grown by a margin with rounded corners, on the floor.
std::vector<Eigen::Vector3d> footprint(const SimulatedRobot &robot, const MotionState &state, double marginM);

/// The sides of a regular prism that stands for a cylinder.
constexpr int cylinderSides = 96;

} // namespace odo
