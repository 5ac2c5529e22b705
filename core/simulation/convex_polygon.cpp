// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/convex_polygon.h"

#include <algorithm>

namespace odo {

namespace {

double cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

double areaOf(const ConvexPolygon &polygon)
{
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return doubled / 2;
}

/// The part of a polygon to the left (side 1) or to the right (−1) of the line from a to b.
ConvexPolygon cut(const ConvexPolygon &polygon, const Eigen::Vector2d &a, const Eigen::Vector2d &b, double side)
{
    ConvexPolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double atP = side * cross(b - a, p - a), atQ = side * cross(b - a, q - a);
        if (atP >= 0)
            kept.push_back(p);
        if ((atP >= 0) != (atQ >= 0))
            kept.emplace_back(p + (q - p) * (atP / (atP - atQ)));
    }
    return kept;
}

} // namespace

ConvexPolygon convexHull(std::vector<Eigen::Vector2d> points)
{
    std::sort(points.begin(), points.end(), [](const Eigen::Vector2d &a, const Eigen::Vector2d &b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    ConvexPolygon hull;
    const auto addChain = [&hull](auto begin, auto end) {
        const std::size_t first = hull.size();
        for (auto point = begin; point != end; ++point) {
            while (hull.size() >= first + 2 && cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(*point);
        }
        hull.pop_back(); // the other chain begins with it
    };
    addChain(points.begin(), points.end());
    addChain(points.rbegin(), points.rend());
    return hull;
}

std::vector<ConvexPolygon> outsideOf(const ConvexPolygon &hole, const ConvexPolygon &polygon)
{
    const double least = 1e-9 * areaOf(polygon); // what rounding leaves
    std::vector<ConvexPolygon> pieces;
    ConvexPolygon rest = polygon;
    for (std::size_t i = 0; i < hole.size() && !rest.empty(); ++i) {
        const Eigen::Vector2d &a = hole[i], &b = hole[(i + 1) % hole.size()];
        if (ConvexPolygon outside = cut(rest, a, b, -1); areaOf(outside) > least)
            pieces.push_back(std::move(outside));
        rest = cut(rest, a, b, 1);
    }
    // All of it outside comes back in one piece.
    return areaOf(rest) > least ? pieces : std::vector<ConvexPolygon>{polygon};
}

} // namespace odo
