// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/floor_positions.h"

#include <optional>
#include <vector>

namespace odo {

struct PlaneEstimate
{
    double planeM = 0; ///< height of the plane on which the views agree best
    double sigmaM = 0; ///< from scatter and calibration
};

/// Height of the plane on which all views see the robot at the same place: weighted least squares of the
/// pairs' disagreement, which is exactly linear in the height (a ray moves on a straight line through the
/// planes), with Huber's weights against false sightings. views: each view's sightings at the same times,
/// laid on the plane z = 0. nullopt: fewer than ten times with two views, or the views look from the same
/// side, so that σ exceeds 25 mm.
std::optional<PlaneEstimate> estimatePlane(const std::vector<std::vector<Sighting>> &views);

} // namespace odo
