// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/support.h"

#include "core/geometry/region_moments.h"

#include <algorithm>
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

/// What is left of a convex polygon on the inner side of a line: n·p ≤ reach.
std::vector<Eigen::Vector2d> cutBy(const std::vector<Eigen::Vector2d> &polygon, const Eigen::Vector2d &n, double reach)
{
    std::vector<Eigen::Vector2d> inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double beyondFrom = n.dot(from) - reach, beyondTo = n.dot(to) - reach;
        if (beyondFrom <= 0)
            inside.push_back(from);
        if ((beyondFrom < 0 && beyondTo > 0) || (beyondFrom > 0 && beyondTo < 0))
            inside.push_back(from + beyondFrom / (beyondFrom - beyondTo) * (to - from));
    }
    return inside;
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

bool isWithinSupport(const std::vector<float> &support, const Eigen::Vector2d &about, const Eigen::Vector2d &place, double beyondPx)
{
    for (std::size_t k = 0; k < support.size(); ++k)
        if (supportDirection(k).dot(place - about) > double(support[k]) + beyondPx)
            return false;
    return true;
}

std::vector<Eigen::Vector2d> supportPolygon(const std::vector<float> &support, const Eigen::Vector2d &about)
{
    constexpr double samePx = 1e-3;  // lines that meet in one point do so but for their rounding
    constexpr double leastPx2 = 0.5; // smaller nothing was seen
    static_assert(supportDirections % 4 == 0, "begins with the lines along the axes");
    if (support.size() != supportDirections || !std::ranges::all_of(support, [](float reach) { return std::isfinite(reach); }))
        return {};
    constexpr std::size_t quarter = supportDirections / 4;
    const double right = support[0], low = support[quarter], left = -support[2 * quarter], high = -support[3 * quarter];
    if (left > right || high > low)
        return {};
    std::vector<Eigen::Vector2d> polygon{{right, high}, {right, low}, {left, low}, {left, high}};
    for (std::size_t k = 0; k < supportDirections; ++k) {
        if (k % quarter != 0)
            polygon = cutBy(polygon, supportDirection(k), support[k]);
    }
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector2d &corner : polygon) {
        if (corners.empty() || (corner - corners.back()).norm() > samePx)
            corners.push_back(corner);
    }
    while (corners.size() > 1 && (corners.front() - corners.back()).norm() <= samePx)
        corners.pop_back();
    if (corners.size() < 3 || polygonMoments(corners).areaPx2 < leastPx2)
        return {};
    for (Eigen::Vector2d &corner : corners)
        corner += about;
    return corners;
}

} // namespace odo
