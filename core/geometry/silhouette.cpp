// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/silhouette.h"

#include "core/base/cancel_scope.h"
#include "core/geometry/convex_hull.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr int circleCorners = 24;

/// Corners of the footprint about its centre, in the world's axes.
std::vector<Vector2d> footprint(const SolidShape &shape, double headingRad)
{
    std::vector<Vector2d> corners;
    if (shape.form == SolidShape::Form::Cylinder) {
        // The polygon of the circle's area.
        const double step = 2 * std::numbers::pi / circleCorners;
        const double radius = shape.lengthM / 2 * std::sqrt(step / std::sin(step));
        for (int i = 0; i < circleCorners; ++i)
            corners.emplace_back(radius * std::cos(i * step), radius * std::sin(i * step));
        return corners;
    }
    const Vector2d along = shape.lengthM / 2 * Vector2d(std::cos(headingRad), std::sin(headingRad));
    const Vector2d across = shape.widthM / 2 * Vector2d(-std::sin(headingRad), std::cos(headingRad));
    return {along + across, along - across, -along - across, -along + across};
}

} // namespace

std::optional<RegionMoments> silhouetteMoments(const FloorView &view, const SolidShape &shape,
                                               const Vector2d &positionInWorld, double headingRad)
{
    endIfCancelled(); // whoever fits a solid asks for thousands
    std::vector<Vector2d> pixels;
    for (const Vector2d &corner : footprint(shape, headingRad)) {
        const Vector2d place = positionInWorld + corner;
        for (const double height : {shape.baseM, shape.topM}) {
            const auto pixel = view.pixelFromWorld({place.x(), place.y(), height});
            if (!pixel)
                return std::nullopt;
            pixels.push_back(*pixel);
            if (shape.baseM == shape.topM)
                break;
        }
    }
    return polygonMoments(convexHull(std::move(pixels)));
}

} // namespace odo
