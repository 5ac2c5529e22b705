// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/convex_polygon.h"

#include <algorithm>

namespace odo {

namespace {

double cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// The part of a polygon to the left (side 1) or to the right (−1) of the line from a to b.
ConvexPolygon cut(const ConvexPolygon &polygon, const Eigen::Vector2d &a, const Eigen::Vector2d &b, double side)
{
    ConvexPolygon kept;
    if (polygon.empty())
        return kept;
    kept.reserve(polygon.size() + 1);
    const auto beyond = [&](const Eigen::Vector2d &point) { return side * cross(b - a, point - a); };
    double atP = beyond(polygon.front());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double atQ = beyond(q);
        if (atP >= 0)
            kept.push_back(p);
        if ((atP >= 0) != (atQ >= 0))
            kept.emplace_back(p + (q - p) * (atP / (atP - atQ)));
        atP = atQ;
    }
    return kept;
}

/// Whether an edge of the first has all of the second on its outer side: how most parts of a body lie to one another.
bool isApart(const ConvexPolygon &hole, const ConvexPolygon &polygon)
{
    for (std::size_t i = 0; i < hole.size(); ++i) {
        const Eigen::Vector2d &a = hole[i], along = hole[(i + 1) % hole.size()] - a;
        if (std::ranges::all_of(polygon, [&](const Eigen::Vector2d &point) { return cross(along, point - a) <= 0; }))
            return true;
    }
    return false;
}

} // namespace

double signedArea(std::span<const Eigen::Vector2d> polygon)
{
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return 0.5 * doubled;
}

std::vector<ConvexPolygon> outsideOf(const ConvexPolygon &hole, const ConvexPolygon &polygon)
{
    if (isApart(hole, polygon))
        return {polygon};
    const double least = 1e-9 * signedArea(polygon); // what rounding leaves
    std::vector<ConvexPolygon> pieces;
    ConvexPolygon rest = polygon;
    for (std::size_t i = 0; i < hole.size() && !rest.empty(); ++i) {
        const Eigen::Vector2d &a = hole[i], &b = hole[(i + 1) % hole.size()];
        if (ConvexPolygon outside = cut(rest, a, b, -1); signedArea(outside) > least)
            pieces.push_back(std::move(outside));
        rest = cut(rest, a, b, 1);
    }
    // All of it outside comes back in one piece.
    return signedArea(rest) > least ? pieces : std::vector<ConvexPolygon>{polygon};
}

} // namespace odo
