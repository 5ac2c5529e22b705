// SPDX-License-Identifier: GPL-3.0-or-later
// What all drawings of a testbed's floor have in common.
#pragma once

#include <Eigen/Core>

namespace odo {

inline constexpr double floorGridM = 0.5;
inline constexpr double floorGrabPx = 12; ///< as near as this a press takes hold of something

/// Where something that is dragged comes to lie: on whole centimetres of the world, in metres.
inline Eigen::Vector2d onDragStep(const Eigen::Vector2d &point)
{
    constexpr double stepM = 0.01;
    return stepM * (point / stepM).array().round().matrix();
}

} // namespace odo
