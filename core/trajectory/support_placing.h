// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/trajectory/body_outline.h"
#include "core/trajectory/reach_correction.h"

#include <optional>

namespace odo {

/// How a body's outlines differ from those of its solid.
struct OutlineDifference
{
    double widerPx = 0; ///< by how much all outlines of a run are drawn too wide
    ReachCorrection reach;
};

/// What is known before of where a solid stands.
struct PlaceGuess
{
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    BodyAxis axis;
};

/// Where a body stands, and its direction.
struct SupportPlace
{
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    BodyAxis axis; ///< σ as the support tells it together with the guess
};

/// Where a solid must stand on the floor, turned about as an axis says, that its outline reaches as far in each direction as was seen, by least squares with Cauchy's loss
/// (ceres::TinySolver): a side of which the outline is missing, or that is drawn too far, takes less part than in the centroid. nullopt: the
/// observation has no support, or the search leaves the picture. Pure.
std::optional<SupportPlace> placeBySupport(const FloorView &view, const SolidShape &shape, const Observation &observation, const OutlineDifference &difference,
                                              const PlaceGuess &guess);

} // namespace odo
