// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/trajectory/analyser.h"

#include <optional>
#include <vector>

namespace odo {

struct ShapeEstimate
{
    SolidShape shape;
    double sigmaTopM = 0;    ///< of the top's height
    double sigmaMiddleM = 0; ///< of the height of its middle: the unknown clearance below it is in it
    bool heightEstimated = false;
    double misfit =
        0; ///< how well the outlines agree with the solid's, in units of their doubt: about 1 is good
};

/// Which solid the outlines of all views are silhouettes of: a box or a cylinder, standing on the floor, or
/// only a plate at the robot's top, or what lies between. One that stands on the floor may do so on wheels: its clearance is estimated where the
/// outlines show it clearly, and doubted otherwise. What was told of its height and size is kept; the
/// rest is estimated, together with a pose for each of some forty times spread over the run, by weighted
/// least squares of the outlines' centroids, areas and second moments over all views (Ceres, Cauchy's loss
/// against outlines that are hidden in part). The views' disagreement about the place tells the height, the
/// outlines' forms tell height and size. σ takes the errors of the outlines as shared by all frames of a
/// quarter of the run. nullopt: fewer than five clear outlines. Pure.
/// Beyond this misfit no such solid explains the outlines.
constexpr double worstShapeMisfit = 4;

std::optional<ShapeEstimate> estimateShape(const std::vector<ViewTrack> &views, const RobotShape &told);

} // namespace odo
