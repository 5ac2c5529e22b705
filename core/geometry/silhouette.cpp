// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/silhouette.h"

#include "core/base/job_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace odo {

namespace {

double cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

void addToChain(std::vector<Eigen::Vector2d> &points, std::size_t first, double turn,
                const Eigen::Vector2d &point)
{
    while (points.size() >= first + 2 &&
           turn * cross(points.back() - points[points.size() - 2], point - points.back()) <= 0)
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

RegionMoments polygonMoments(const std::vector<Eigen::Vector2d> &corners)
{
    RegionMoments moments;
    if (corners.size() < 3)
        return moments;
    const Eigen::Vector2d &origin = corners.front(); // keeps the sums well conditioned
    double twice = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    Eigen::Vector2d p = corners.back() - origin;
    for (const Eigen::Vector2d &point : corners) {
        const Eigen::Vector2d q = point - origin, s = p + q;
        const double cross = p.x() * q.y() - p.y() * q.x();
        twice += cross;
        x += cross * s.x();
        y += cross * s.y();
        xx += cross * (p.x() * p.x() + q.x() * q.x() + s.x() * s.x());
        xy += cross * (p.x() * p.y() + q.x() * q.y() + s.x() * s.y());
        yy += cross * (p.y() * p.y() + q.y() * q.y() + s.y() * s.y());
        p = q;
    }
    moments.areaPx2 = std::abs(twice) / 2;
    if (moments.areaPx2 <= 0)
        return moments;
    const Eigen::Vector2d mean = Eigen::Vector2d(x, y) / (3 * twice);
    moments.centrePx = origin + mean;
    moments.covariancePx2 << xx, xy, xy, yy;
    moments.covariancePx2 /= 12 * twice;
    moments.covariancePx2 -= mean * mean.transpose();
    return moments;
}

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

/// Corners of a level about the solid's position, along and across its heading.
void addCorners(const SolidLevel &level, double roundShare, std::vector<Vector2d> &corners)
{
    constexpr double leastRadiusM = 0.002; // a smaller one is not seen
    const double radius = roundShare * std::min(level.frontM + level.backM, level.leftM + level.rightM) / 2;
    for (const double forward : {1.0, -1.0}) {
        for (const double left : {1.0, -1.0}) {
            const Vector2d corner(forward > 0 ? level.frontM : -level.backM,
                                  left > 0 ? level.leftM : -level.rightM);
            if (radius < leastRadiusM) {
                corners.push_back(corner);
                continue;
            }
            const Vector2d middle = corner - radius * Vector2d(forward, left);
            for (const Vector2d &direction :
                 {Vector2d(1, 0), Vector2d(std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2), Vector2d(0, 1)})
                corners.emplace_back(middle + radius * direction.cwiseProduct(Vector2d(forward, left)));
        }
    }
}

bool addPixels(const FloorView &view, const std::vector<Vector2d> &positions, double heightM,
               std::vector<Vector2d> &pixels)
{
    for (const Vector2d &position : positions) {
        const auto pixel = view.pixelFromWorld({position.x(), position.y(), heightM});
        if (!pixel)
            return false;
        pixels.push_back(*pixel);
    }
    return true;
}

/// Corners of the solid in the image: its outline is their convex hull.
std::optional<std::vector<Vector2d>> cornerPixels(const FloorView &view, const SolidShape &shape,
                                                  const Vector2d &positionInWorld, double headingRad)
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
    if (!addPixels(view, corners, shape.baseM, pixels) ||
        (shape.baseM != shape.topM && !addPixels(view, corners, shape.topM, pixels)))
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
        shape.levels[i] = {(1 - share) * shape.baseM + share * shape.topM, shape.lengthM / 2,
                           shape.lengthM / 2, shape.widthM / 2, shape.widthM / 2};
    }
    shape.roundShare = shape.form == SolidShape::Form::Cylinder ? 1 : 0;
    shape.form = SolidShape::Form::Levels;
    return shape;
}

SolidShape shiftedPosition(SolidShape levels, const Vector2d &shiftM)
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

std::optional<std::vector<float>> silhouetteSupport(const FloorView &view, const SolidShape &shape,
                                                    const Vector2d &positionInWorld, double headingRad,
                                                    const Vector2d &aboutPx)
{
    const auto pixels = cornerPixels(view, shape, positionInWorld, headingRad);
    return pixels ? std::optional(supportOf(*pixels, aboutPx)) : std::nullopt;
}

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
std::vector<Eigen::Vector2d> cutBy(const std::vector<Eigen::Vector2d> &polygon, const Eigen::Vector2d &n,
                                   double reach)
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

bool isWithinSupport(const std::vector<float> &support, const Eigen::Vector2d &about,
                     const Eigen::Vector2d &position, double beyondPx)
{
    for (std::size_t k = 0; k < support.size(); ++k)
        if (supportDirection(k).dot(position - about) > double(support[k]) + beyondPx)
            return false;
    return true;
}

std::vector<Eigen::Vector2d> supportPolygon(const std::vector<float> &support, const Eigen::Vector2d &about)
{
    constexpr double samePx = 1e-3;  // lines that meet in one point do so but for their rounding
    constexpr double leastPx2 = 0.5; // smaller nothing was seen
    static_assert(supportDirections % 4 == 0, "begins with the lines along the axes");
    if (support.size() != supportDirections ||
        !std::ranges::all_of(support, [](float reach) { return std::isfinite(reach); }))
        return {};
    constexpr std::size_t quarter = supportDirections / 4;
    const double right = support[0], low = support[quarter], left = -support[2 * quarter],
                 high = -support[3 * quarter];
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
