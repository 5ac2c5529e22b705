// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/internal/polygon_layer.h"
#include "core/simulation/scene.h"

#include <vector>

namespace odo {

/// A flat face of a body, convex, corners in order, world frame, with its shaded colour.
struct BodyFace
{
    std::vector<Eigen::Vector3d> corners;
    Rgb colour;
};

/// The faces of a robot's parts that a camera can see, cut to what no nearer part hides: they do not overlap
/// in its image. What lies level has its part's colour, sides the same hue, darker, depending on where they
/// face.
std::vector<BodyFace> visibleFaces(const SimulatedRobot &robot, const MotionState &state,
                                   const Eigen::Vector3d &cameraInWorld);

/// Its mirror image in the floor, likewise.
std::vector<BodyFace> mirroredFaces(const SimulatedRobot &robot, const MotionState &state,
                                    const Eigen::Vector3d &cameraInWorld);

/// The shadow that a point of light casts on the floor, in convex pieces that do not overlap. Parts that
/// reach as high as the light cast none.
std::vector<std::vector<Eigen::Vector3d>> castShadow(const SimulatedRobot &robot, const MotionState &state,
                                                     const Eigen::Vector3d &lightInWorld);

/// The robot's footprint grown by a margin with rounded corners, on the floor.
std::vector<Eigen::Vector3d> footprint(const SimulatedRobot &robot, const MotionState &state, double marginM);

} // namespace odo
