// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/body_outline.h"
#include "core/trajectory/support_placing.h"

#include <vector>

namespace odo {

/// The body's axis at the time of every observation of every view, in their order: from the outlines of all
/// views, smoothed over time together (as the point (cos 2α, sin 2α), which knows no jump at the half turn,
/// by the Kalman smoother that serves the positions). σ is at least that of the doubt about the outlines,
/// which does not average out. Where no outline tells, σ is larger than unknownAxisSigmaRad. Views that are
/// not registered give nothing.
std::vector<std::vector<BodyAxis>> trackAxis(const std::vector<ViewTrack> &views, const SolidShape &shape);

/// Where a body stood at a time, and its direction.
struct BodyPose
{
    Nanoseconds time{0}; ///< of the first view's clock
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double headingRad = 0;
};

/// The same of a solid whose two ends differ, as the supports of its outlines tell it (placeBySupport): followed from observation to observation, from the poses that are
/// known, of which there is at least one, in order. Directions modulo 2π.
std::vector<std::vector<BodyAxis>> trackDirection(const std::vector<ViewTrack> &views, const SolidShape &shape, const OutlineDifference &difference,
                                                  const std::vector<BodyPose> &poses);

} // namespace odo
