// SPDX-License-Identifier: GPL-3.0-or-later
// What all drawings of a testbed's floor have in common.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace odo {

inline constexpr double floorGridM = 0.5;
inline constexpr double floorGrabPx = 12; ///< as near as this a press takes hold of something

/// Where the grid has lines between two coordinates. None where they would be all that is to be seen, as of a
/// layout in a wrong unit.
inline std::vector<double> floorGridLines(double fromM, double toM)
{
    constexpr double mostLines = 200;
    std::vector<double> lines;
    if (!((toM - fromM) / floorGridM <= mostLines)) // nor of what is no number
        return lines;
    for (double line = std::ceil(fromM / floorGridM);
         line * floorGridM <= toM + 1e-9 && lines.size() <= mostLines; ++line)
        lines.push_back(line * floorGridM);
    return lines;
}

/// Where something that is dragged comes to lie: on whole centimetres of the world, in metres.
inline Eigen::Vector2d onDragStep(const Eigen::Vector2d &point)
{
    constexpr double stepM = 0.01;
    return stepM * (point / stepM).array().round().matrix();
}

} // namespace odo
