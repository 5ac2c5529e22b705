// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/support.h"

#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

std::array<Eigen::Vector2d, supportDirections> allDirections()
{
    std::array<Eigen::Vector2d, supportDirections> directions;
    for (std::size_t k = 0; k < supportDirections; ++k) {
        const double angle = 2 * std::numbers::pi * double(k) / double(supportDirections);
        directions[k] = {std::cos(angle), std::sin(angle)};
    }
    return directions;
}

} // namespace

Eigen::Vector2d supportDirection(std::size_t k)
{
    static const auto directions = allDirections();
    return directions[k];
}

std::vector<float> supportOf(const std::vector<Eigen::Vector2d> &points, const Eigen::Vector2d &about)
{
    std::vector<float> support(supportDirections);
    for (std::size_t k = 0; k < supportDirections; ++k) {
        const Eigen::Vector2d direction = supportDirection(k);
        double farthest = -HUGE_VAL;
        for (const Eigen::Vector2d &point : points)
            farthest = std::max(farthest, direction.dot(point - about));
        support[k] = float(farthest);
    }
    return support;
}

} // namespace odo
