// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/floor_positions.h"

#include <vector>

namespace odo {

/// A horizontal plane that a robot's outlines are laid on: that of their centres.
struct PlaneChoice
{
    double planeM = 0, sigmaM = 0; ///< height over the floor
    double heightM = 0;            ///< of the robot's top; 0: not known
    bool estimated = false;        ///< from the views' disagreement, not told
};

/// Each view's sightings on a plane at common times, in their order. Unregistered views see nothing.
std::vector<std::vector<Sighting>> lookFromAllViews(const std::vector<ViewTrack> &views,
                                                    const std::vector<Nanoseconds> &times, double planeM);

/// The plane of a robot whose form is not known: by the height told (a mark at its top lies there, a body's
/// silhouette half as high), or the one on which the views agree best, or, with one view alone, the floor.
PlaneChoice choosePlane(const std::vector<ViewTrack> &views, const std::vector<Nanoseconds> &times,
                        const RobotShape &shape);

} // namespace odo
