// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/robot_follower.h"

#include <vector>

namespace odo {

/// Follows, in one frame, robots that are near one another in the picture and whose colours do not tell their
/// samples apart. All regions are found once for all of them and shared out at once, by place, size and mean
/// colour. Where fewer regions than robots are there, some are one in the picture: then their last outlines
/// are laid over the region, and each gets a coarse place of low score; none takes the whole region's centre.
/// Keeps its memory.
class SimilarRobots
{
public:
    /// robots: all are being followed. observations: one a robot, left as they are where it is not found.
    void follow(const TrackedFrame &frame, const std::vector<RobotFollower *> &robots,
                const std::vector<Observation *> &observations);

private:
    std::vector<int> share(const TrackedFrame &frame, const std::vector<RobotFollower *> &robots) const;
    void paintShared(const RobotFollower &finder, const std::vector<int> &choices, int region);
    void separate(const TrackedFrame &frame, const std::vector<RobotFollower *> &robots,
                  const std::vector<Observation *> &observations, const std::vector<int> &choices,
                  int region);

    std::vector<Blob> m_regions; ///< of this frame that are large enough to be a robot's
    RegionMask m_shared, m_piece;
};

} // namespace odo
