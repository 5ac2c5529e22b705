// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/floor_view.h"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace odo {

/// Adds a point to a chain, those of `points` from `first` on: what comes in order along a line of which the
/// hull lies to one side. In it stay those that the hull may have as corners. turn: 1 or −1, to which side
/// the hull turns along the chain; 1: from x to y.
void addToChain(std::vector<Eigen::Vector2d> &points, std::size_t first, double turn,
                const Eigen::Vector2d &point);

/// The corners of the smallest convex polygon around points, anticlockwise where y points up, by the monotone
/// chain (A. M. Andrew 1979). At least three points that do not lie on one line. Pure.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);

/// Area, centroid and second central moments of a region of the image. Pixels.
struct RegionMoments
{
    double areaPx2 = 0;
    Eigen::Vector2d centrePx = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariancePx2 = Eigen::Matrix2d::Zero();
};

/// Exact for a polygon with its corners in order, in either orientation (Green's theorem; Steger 1996, "On
/// the calculation of arbitrary moments of polygons"). No area for fewer than three corners.
RegionMoments polygonMoments(const std::vector<Eigen::Vector2d> &corners);

/// A horizontal rectangle of a solid. Its sides lie along and across the heading, so far from the solid's
/// position.
struct SolidLevel
{
    double heightM = 0; ///< above the floor
    double frontM = 0, backM = 0, leftM = 0, rightM = 0;
};

/// The solid of a robot: an upright box or cylinder between two heights above the floor, or the convex hull
/// of three levels. A plate on a robot of another colour has equal heights. Metres.
struct SolidShape
{
    enum class Form { Box, Cylinder, Levels };
    Form form = Form::Box;
    /// along and across the heading, of all of it; of a cylinder both are the diameter
    double lengthM = 0, widthM = 0;
    double baseM = 0, topM = 0; ///< above the floor
    /// of Form::Levels, from below; the middle of what they cover is the position, unless shiftedPosition
    /// moved it
    std::array<SolidLevel, 3> levels = {};
    /// of Form::Levels: radius of their corners against half of their shorter side, 0 to 1
    double roundShare = 0;
};

/// The same solid as one of levels.
SolidShape asLevels(SolidShape shape);
/// A solid of levels with its reference point moved so far forward and left. Metres.
SolidShape shiftedPosition(SolidShape levels, const Eigen::Vector2d &shiftM);

/// What a view sees of the solid with its footprint's centre at a floor position, its length turned by
/// headingRad from the world's X: the moments of the outline that its projected edges enclose (for a convex
/// solid the convex hull of its corners; a circle counts as 24 corners of the same area). Edges count as
/// straight between corners, and a round corner as three: over the size of a robot distortion bends them by
/// less than 0.05 px. nullopt: a corner lies behind the camera, or where the lens model folds.
std::optional<RegionMoments> silhouetteMoments(const FloorView &view, const SolidShape &shape,
                                               const Eigen::Vector2d &positionInWorld, double headingRad);
/// The support function of what a view sees of it (core/geometry/silhouette.h), about a pixel. nullopt: as
/// before.
std::optional<std::vector<float>> silhouetteSupport(const FloorView &view, const SolidShape &shape,
                                                    const Eigen::Vector2d &positionInWorld, double headingRad,
                                                    const Eigen::Vector2d &aboutPx);

/// Directions of the image in which the extent of a region is measured: direction k is at 2πk/24 from the x
/// axis toward y (down).
constexpr std::size_t supportDirections = 24;
Eigen::Vector2d supportDirection(std::size_t k);

/// The support function of a region in each direction: how far it, and with it its convex hull, reaches from
/// a point, max over the points of n·(point − about). Pixels. points: at least one. Pure.
std::vector<float> supportOf(const std::vector<Eigen::Vector2d> &points, const Eigen::Vector2d &about);

/// Whether a point is within all support lines, or at most so far beyond one. Pure.
bool isWithinSupport(const std::vector<float> &support, const Eigen::Vector2d &about,
                     const Eigen::Vector2d &position, double beyondPx = 0);

/// The polygon that a support function bounds: the points p with n·(p − about) ≤ support in every direction.
/// Its corners in pixels, in the order of the directions, none twice. It contains the region's convex hull
/// and touches each of its support lines. Empty where the lines leave no area between them, for fewer or more
/// numbers than there are directions, and for numbers that are not finite. Pure.
std::vector<Eigen::Vector2d> supportPolygon(const std::vector<float> &support, const Eigen::Vector2d &about);

} // namespace odo
