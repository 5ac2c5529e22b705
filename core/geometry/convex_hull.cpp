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

void addToChain(std::vector<Eigen::Vector2d> &points, std::size_t first, double turn, const Eigen::Vector2d &point)
{
    while (points.size() >= first + 2 && turn * cross(points.back() - points[points.size() - 2], point - points.back()) <= 0)
        points.pop_back();
    points.push_back(point);
}

std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points)
{
    std::sort(points.begin(), points.end(), [](const Eigen::Vector2d &a, const Eigen::Vector2d &b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    std::vector<Eigen::Vector2d> hull;
    const auto addChain = [&hull](auto begin, auto end) {
        const std::size_t first = hull.size();
        for (auto point = begin; point != end; ++point)
            addToChain(hull, first, 1, *point);
        hull.pop_back(); // it begins the other chain
    };
    addChain(points.begin(), points.end());
    addChain(points.rbegin(), points.rend());
    return hull;
}

} // namespace odo
