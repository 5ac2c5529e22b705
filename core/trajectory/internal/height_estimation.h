// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/floor_positions.h"

#include <optional>
#include <vector>

namespace odo {

struct PlaneEstimate
{
    double planeM = 0; ///< height of the plane on which the views agree best
    double sigmaM = 0; ///< from scatter and calibration
};

/// Height of the plane on which all views see the robot at the same position: weighted least squares of the
/// pairs' disagreement, which is exactly linear in the height (a ray moves on a straight line through the
/// planes), with Huber's weights against false sightings. views: each view's sightings at the same times,
/// projected onto the plane z = 0. nullopt: fewer than ten times with two views, or the views look from the
/// same side, so that σ exceeds 25 mm.
std::optional<PlaneEstimate> estimatePlane(const std::vector<std::vector<Sighting>> &views);

/// A horizontal plane onto which a robot's outlines are projected: that of their centres.
struct PlaneChoice
{
    double planeM = 0, sigmaM = 0; ///< height over the floor
    double heightM = 0;            ///< of the robot's top; 0: not known
    bool estimated = false;        ///< from the views' disagreement, not given
};

/// Each view's sightings on a plane at common times, in their order. Unregistered views see nothing.
std::vector<std::vector<Sighting>> viewFromAllSides(const std::vector<ViewTrack> &views,
                                                    const std::vector<Nanoseconds> &times, double planeM);

/// The plane of a robot whose form is not known: by the given height (a mark at its top lies there, a body's
/// silhouette half as high), or the one on which the views agree best, or, with one view alone, the floor.
PlaneChoice choosePlane(const std::vector<ViewTrack> &views, const std::vector<Nanoseconds> &times,
                        const RobotShape &shape);

/// Whether what the views see is only a mark at the robot's top (a cap, a ball on a mast) and not a body that
/// reaches down to the floor: the outline is then shorter than half of what a body of that height would span
/// in the image, from its foot to its top. Median over all sightings; false where there is none.
bool isMarkAtTop(const std::vector<ViewTrack> &views, double heightM);

} // namespace odo
