// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/tracking/observation.h"
#include "core/trajectory/analyser.h"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace odo {

/// The direction of a body's length on the floor, whose front and back an outline does not distinguish:
/// modulo π.
struct BodyAxis
{
    double angleRad = 0; ///< from the world's X
    double sigmaRad = 0; ///< above half a radian nothing is known
};

/// Beyond it an axis is meaningless: a direction drawn at random has 52°.
constexpr double unknownAxisSigmaRad = 0.5;

/// What the tracker measured of an outline, as moments of a region.
RegionMoments outlineMoments(const Observation &observation);

/// By how much all of an outline may be drawn too wide or too narrow (shadow at the foot, motion blur,
/// coding): the error that the area and the second moments of all frames share. Pixels.
constexpr double outlineSigmaPx = 0.15;

/// σ of an outline's area as a share of itself, and of its second moments in px², that follow from the
/// uncertainty.
struct OutlineSigma
{
    double areaShare = 0;
    double covariancePx2 = 0;
};
OutlineSigma sigmaOfOutline(const RegionMoments &outline);

/// An outline that was seen against that of a solid: two differences of the centroid, of the area's
/// logarithm, three of the second moments, each over its σ.
using OutlineDifferences = Eigen::Matrix<double, 6, 1>;
OutlineDifferences outlineDifferences(const RegionMoments &seen, const RegionMoments &model,
                                      const OutlineSigma &sigma, double centroidSigmaPx);

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
/// Gauss–Newton; σ from the outline's uncertainty. nullopt: no axis there explains the outline (what is seen
/// is hidden in part, or merged with something).
std::optional<BodyAxis> axisNear(const OutlineMisfit &misfit, double angleRad);

/// Position of the solid, turned to an angle, for which the centroid of its silhouette is the given pixel:
/// the pixel that the footprint's centre, lifted to the solid's middle height, would have. nullopt: beyond
/// the horizon.
std::optional<Eigen::Vector2d> pixelOfBodyMiddle(const FloorView &view, const SolidShape &shape,
                                                 const Eigen::Vector2d &centroidPx, double angleRad);

/// The height of that middle.
constexpr double middleHeightM(const SolidShape &shape)
{
    return (shape.baseM + shape.topM) / 2;
}

/// Of an outline that shows the whole robot.
constexpr double leastOutlineScore = 0.5;

/// The outlines that the views saw at one time: of each registered view, where it saw the whole robot
/// clearly.
struct CommonOutlines
{
    struct Outline
    {
        const FloorView *view = nullptr; ///< owned by the tracks given
        RegionMoments moments;
        std::vector<float> supportPx; ///< as of Observation
    };
    std::vector<Outline> outlines; ///< at least one
    Nanoseconds time{0};           ///< of the first view's clock
};

/// Outlines at up to `most` times spread evenly over the run, of as many views each as saw it: those of other
/// views interpolated linearly between their two frames around. Clear means: found with a score of at least
/// 0.5, not cut by the frame's edge, in no repeated frame. Times with several views are preferred: one
/// view's are taken only where there are fewer than five of the former.
std::vector<CommonOutlines> commonOutlines(const std::vector<ViewTrack> &views, std::size_t most);

/// By how much a body reaches farther than the simple solid that stands for it, in each direction: the
/// support function of its convex hull less that of the solid's, in metres, kept on a lattice of directions
/// and interpolated between them. Robot's frame: x forward, y to the left, z up.
class ReachCorrection
{
public:
    static constexpr int azimuths = 36, elevations = 15;   ///< of the lattice
    static constexpr double stepRad = 0.17453292519943295; ///< 10°
    static constexpr int nodes = azimuths * elevations;

    /// None.
    ReachCorrection() = default;
    explicit ReachCorrection(Eigen::VectorXd valuesM) : m_valuesM(std::move(valuesM)) {}

    /// direction: of any length.
    double at(const Eigen::Vector3d &direction) const;

    /// The nodes about a direction and what each counts there.
    struct Weights
    {
        std::array<int, 4> node{};
        std::array<double, 4> weight{};
    };
    static Weights weightsAt(const Eigen::Vector3d &direction);
    static Eigen::Vector3d directionOf(int node);

private:
    Eigen::VectorXd m_valuesM; ///< of the nodes; empty: none
};

/// How a body's outlines differ from those of its solid.
struct OutlineDifference
{
    double widerPx = 0; ///< by how much all outlines of a run are drawn too wide
    ReachCorrection reach;
};

/// Prior knowledge of a solid's position.
struct PositionGuess
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    BodyAxis axis;
};

/// Position and direction of a body.
struct SupportPosition
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    BodyAxis axis; ///< σ from the support together with the guess
};

/// Floor position of a solid, turned about as an axis says, for which its outline reaches as far in each
/// direction as was seen, by least squares with Cauchy's loss (ceres::TinySolver): a side of which the
/// outline is missing, or that is drawn too far, takes less part than in the centroid. nullopt: the
/// observation has no support, or the search leaves the image. Pure.
std::optional<SupportPosition> positionBySupport(const FloorView &view, const SolidShape &shape,
                                                 const Observation &observation,
                                                 const OutlineDifference &difference,
                                                 const PositionGuess &guess);

} // namespace odo
