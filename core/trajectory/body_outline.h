// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/tracking/observation.h"

#include <Eigen/Core>
#include <optional>

namespace odo {

/// The direction of a body's length on the floor, of which an outline does not tell front from back: modulo
/// π.
struct BodyAxis
{
    double angleRad = 0; ///< from the world's X
    double sigmaRad = 0; ///< above half a radian nothing is known
};

/// Beyond it an axis tells nothing: a direction drawn at random has 52°.
constexpr double unknownAxisSigmaRad = 0.5;

/// What the tracker measured of an outline, as moments of a region.
RegionMoments outlineMoments(const Observation &observation);

/// By how much all of an outline may be drawn too wide or too narrow (shadow at the foot, motion blur,
/// coding): the error that the area and the second moments of all frames share. Pixels.
constexpr double outlineDoubtPx = 0.15;

/// σ of an outline's area as a share of itself, and of its second moments in px², that follow from the doubt.
struct OutlineSigma
{
    double areaShare = 0;
    double covariancePx2 = 0;
};
OutlineSigma sigmaOfOutline(const RegionMoments &outline);

/// The angle at which the solid, standing at a place, has the silhouette whose second moments come nearest to
/// those seen. nullopt: it would lie behind the camera.
std::optional<double> bestAxis(const FloorView &view, const SolidShape &shape, const RegionMoments &seen,
                               const Eigen::Vector2d &position);

/// The axis at which the solid's silhouette has the second moments that were seen: the best of a search over
/// the half turn, refined by Gauss–Newton; σ from the doubt about the outline. A guess near the answer saves
/// the search. nullopt: a cylinder has no axis; the body would lie behind the camera; or no axis explains the
/// outline (what is seen is hidden in part, or merged with something).
std::optional<BodyAxis> axisFromOutline(const FloorView &view, const SolidShape &shape,
                                        const Observation &observation, std::optional<double> guessRad);

/// Where the solid must stand, turned to an angle, that the centroid of its silhouette is the pixel given:
/// the pixel that the footprint's centre, lifted to the solid's middle height, would have. nullopt: beyond
/// the horizon.
std::optional<Eigen::Vector2d> pixelOfBodyMiddle(const FloorView &view, const SolidShape &shape,
                                                 const Eigen::Vector2d &centroidPx, double angleRad);

/// The height of that middle.
constexpr double middleHeightM(const SolidShape &shape)
{
    return (shape.baseM + shape.topM) / 2;
}

} // namespace odo
