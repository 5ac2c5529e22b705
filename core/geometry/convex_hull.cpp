// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/convex_hull.h"

#include <algorithm>

namespace odo {

namespace {

double cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points)
{
    std::sort(points.begin(), points.end(), [](const Eigen::Vector2d &a, const Eigen::Vector2d &b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    std::vector<Eigen::Vector2d> hull;
    const auto addChain = [&hull](auto begin, auto end) {
        const std::size_t first = hull.size();
        for (auto point = begin; point != end; ++point) {
            while (hull.size() >= first + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(*point);
        }
        hull.pop_back(); // it begins the other chain
    };
    addChain(points.begin(), points.end());
    addChain(points.rbegin(), points.rend());
    return hull;
}

} // namespace odo
