// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/silhouette.h"

#include "core/base/cancel_scope.h"
#include "core/geometry/convex_hull.h"
#include "core/geometry/support.h"

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

/// Corners of a level about the solid's place, along and across its heading.
void addCorners(const SolidLevel &level, double roundShare, std::vector<Vector2d> &corners)
{
    constexpr double leastRadiusM = 0.002; // a smaller one is not seen
    const double radius = roundShare * std::min(level.frontM + level.backM, level.leftM + level.rightM) / 2;
    for (const double forward : {1.0, -1.0}) {
        for (const double left : {1.0, -1.0}) {
            const Vector2d corner(forward > 0 ? level.frontM : -level.backM, left > 0 ? level.leftM : -level.rightM);
            if (radius < leastRadiusM) {
                corners.push_back(corner);
                continue;
            }
            const Vector2d middle = corner - radius * Vector2d(forward, left);
            for (const Vector2d &direction : {Vector2d(1, 0), Vector2d(std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2), Vector2d(0, 1)})
                corners.emplace_back(middle + radius * direction.cwiseProduct(Vector2d(forward, left)));
        }
    }
}

bool addPixels(const FloorView &view, const std::vector<Vector2d> &places, double heightM, std::vector<Vector2d> &pixels)
{
    for (const Vector2d &place : places) {
        const auto pixel = view.pixelFromWorld({place.x(), place.y(), heightM});
        if (!pixel)
            return false;
        pixels.push_back(*pixel);
    }
    return true;
}

/// Corners of the solid in the picture: its outline is their convex hull.
std::optional<std::vector<Vector2d>> cornerPixels(const FloorView &view, const SolidShape &shape, const Vector2d &positionInWorld, double headingRad)
{
    std::vector<Vector2d> pixels;
    if (shape.form == SolidShape::Form::Levels) {
        const Vector2d along(std::cos(headingRad), std::sin(headingRad)), across(-along.y(), along.x());
        std::vector<Vector2d> corners;
        for (const SolidLevel &level : shape.levels) {
            corners.clear();
            addCorners(level, shape.roundShare, corners);
            for (Vector2d &corner : corners)
                corner = positionInWorld + corner.x() * along + corner.y() * across;
            if (!addPixels(view, corners, level.heightM, pixels))
                return std::nullopt;
        }
        return pixels;
    }
    std::vector<Vector2d> corners = footprint(shape, headingRad);
    for (Vector2d &corner : corners)
        corner += positionInWorld;
    if (!addPixels(view, corners, shape.baseM, pixels) || (shape.baseM != shape.topM && !addPixels(view, corners, shape.topM, pixels)))
        return std::nullopt;
    return pixels;
}

} // namespace

SolidShape asLevels(SolidShape shape)
{
    if (shape.form == SolidShape::Form::Levels)
        return shape;
    for (std::size_t i = 0; i < shape.levels.size(); ++i) {
        const double share = double(i) / double(shape.levels.size() - 1);
        shape.levels[i] = {(1 - share) * shape.baseM + share * shape.topM, shape.lengthM / 2, shape.lengthM / 2, shape.widthM / 2, shape.widthM / 2};
    }
    shape.roundShare = shape.form == SolidShape::Form::Cylinder ? 1 : 0;
    shape.form = SolidShape::Form::Levels;
    return shape;
}

SolidShape movedPlace(SolidShape levels, const Vector2d &shiftM)
{
    for (SolidLevel &level : levels.levels) {
        level.frontM -= shiftM.x();
        level.backM += shiftM.x();
        level.leftM -= shiftM.y();
        level.rightM += shiftM.y();
    }
    return levels;
}

std::optional<RegionMoments> silhouetteMoments(const FloorView &view, const SolidShape &shape,
                                               const Vector2d &positionInWorld, double headingRad)
{
    endIfCancelled(); // whoever fits a solid asks for thousands
    auto pixels = cornerPixels(view, shape, positionInWorld, headingRad);
    return pixels ? std::optional(polygonMoments(convexHull(std::move(*pixels)))) : std::nullopt;
}

std::optional<std::vector<float>> silhouetteSupport(const FloorView &view, const SolidShape &shape, const Vector2d &positionInWorld, double headingRad,
                                                    const Vector2d &aboutPx)
{
    const auto pixels = cornerPixels(view, shape, positionInWorld, headingRad);
    return pixels ? std::optional(supportOf(*pixels, aboutPx)) : std::nullopt;
}

} // namespace odo
