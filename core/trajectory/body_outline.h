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

/// An outline that was seen against that of a solid: two differences of the centroid, of the area's logarithm, three of the second moments, each
/// over its σ.
using OutlineDifferences = Eigen::Matrix<double, 6, 1>;
OutlineDifferences outlineDifferences(const RegionMoments &seen, const RegionMoments &model, const OutlineSigma &sigma, double centroidSigmaPx);

/// How badly the solid, standing where the outline's centroid is seen, explains its second moments when
/// turned to an angle: the three differences in units of their σ. nullopt: it would lie behind the camera.
class OutlineMisfit
{
public:
    /// nullopt: the centroid lies beyond the horizon.
    static std::optional<OutlineMisfit> create(const FloorView &view, const SolidShape &shape,
                                               const RegionMoments &seen);
    std::optional<Eigen::Vector3d> at(double angleRad) const;

private:
    OutlineMisfit(const FloorView &view, const SolidShape &shape, const RegionMoments &seen,
                  const Eigen::Vector2d &position);

    const FloorView *m_view;
    const SolidShape *m_shape;
    RegionMoments m_seen;
    Eigen::Vector2d m_position;
    double m_sigmaPx2;
};

/// Mean and σ of the axis over ±0.2 rad about an angle, each angle weighing exp(−misfit²/2): fair also where
/// an outline seen nearly face on fits two angles mirrored about it alike. nullopt as of axisNear.
std::optional<BodyAxis> axisAbout(const OutlineMisfit &misfit, double angleRad);

/// The axis near an angle at which the solid's silhouette has the second moments that were seen, by
/// Gauss–Newton; σ from the doubt about the outline. nullopt: no axis there explains the outline (what is
/// seen is hidden in part, or merged with something).
std::optional<BodyAxis> axisNear(const OutlineMisfit &misfit, double angleRad);

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
