// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"
#include "core/trajectory/view_clock.h"

#include <cstddef>
#include <vector>

namespace odo {

/// A stretch of one robot's observations in one view in which it surely stays the same thing: found in every
/// frame with a usable score. Between two of them it was lost, or one with another robot in the picture, and
/// may have been taken for another one.
struct Tracklet
{
    struct End
    {
        double timeS = 0; ///< on the first view's clock
        Eigen::Vector2d positionPx = Eigen::Vector2d::Zero(), velocityPxPerS = Eigen::Vector2d::Zero();
        double radiusPx = 0; ///< of the circle of the region's area
    };
    std::size_t first = 0, last = 0; ///< indices of observations, both inside
    End begin, end;
    Eigen::Vector2d meanChroma = Eigen::Vector2d::Zero(); ///< zero where unknown
};

/// Whether an observation surely shows one robot, whichever. Below this score it may be a part of one, or
/// several.
bool isSure(const Observation &observation);

/// Cuts a robot's observations (in order of time) into tracklets. Stretches of fewer than three frames are
/// left out: they tell nothing of a motion.
std::vector<Tracklet> cutIntoTracklets(const std::vector<Observation> &observations, const ViewClock &clock);

/// What speaks against one robot having run from the end of one tracklet to the begin of a later one: half
/// the squared standard deviations, capped, of where both motions put it halfway and of the change of
/// velocity. Allows for an acceleration of some two metres per second squared of a robot of the usual size.
double costOfJoining(const Tracklet::End &end, const Tracklet::End &begin);

} // namespace odo
