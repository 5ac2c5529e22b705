// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/reach_correction.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double lowestRad = -(ReachCorrection::elevations - 1) / 2.0 * ReachCorrection::stepRad; // beyond the ends it is as at them

} // namespace

ReachCorrection::Weights ReachCorrection::weightsAt(const Eigen::Vector3d &direction)
{
    const double up = std::atan2(direction.z(), direction.head<2>().norm());
    const double row = std::clamp((up - lowestRad) / stepRad, 0.0, double(elevations - 1));
    const double turn = std::atan2(direction.y(), direction.x()) / stepRad;
    const double column = turn < 0 ? turn + azimuths : turn;
    const int below = std::min(int(row), elevations - 2), before = int(column) % azimuths, behind = (before + 1) % azimuths;
    const double v = row - below, u = column - std::floor(column);
    return {{below * azimuths + before, below * azimuths + behind, (below + 1) * azimuths + before, (below + 1) * azimuths + behind},
            {(1 - v) * (1 - u), (1 - v) * u, v * (1 - u), v * u}};
}

Eigen::Vector3d ReachCorrection::directionOf(int node)
{
    const double up = lowestRad + node / azimuths * stepRad, turn = node % azimuths * stepRad;
    return {std::cos(up) * std::cos(turn), std::cos(up) * std::sin(turn), std::sin(up)};
}

double ReachCorrection::at(const Eigen::Vector3d &direction) const
{
    if (m_valuesM.size() == 0)
        return 0;
    const Weights weights = weightsAt(direction);
    double sum = 0;
    for (std::size_t i = 0; i < weights.node.size(); ++i)
        sum += weights.weight[i] * m_valuesM[weights.node[i]];
    return sum;
}

} // namespace odo
