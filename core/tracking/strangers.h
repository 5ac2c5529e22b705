// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/blob_finder.h"
#include "core/tracking/tracked_frame.h"

#include <vector>

namespace odo {

/// A robot as it was when it was lost.
struct LostRobot
{
    Eigen::Vector2d placePx = Eigen::Vector2d::Zero(); ///< where it should be now
    double radiusPx = 0, areaPx = 0;
    double sinceS = 0;     ///< since it was last seen
    bool justLost = false; ///< this is the first frame without it
};

/// What has a robot's colour elsewhere at the moment of its loss is not the robot, as long as it stands
/// there.
class Strangers
{
public:
    void clear() { m_strangers.clear(); }
    /// Forgets those that are gone; at the moment of the loss, notes all that are there.
    void note(const TrackedFrame &frame, const std::vector<Blob> &blobs, const LostRobot &lost);
    bool contain(const TrackedFrame &frame, const Blob &blob, double radiusPx) const;

private:
    struct Stranger
    {
        Eigen::Vector2d centrePx;
        double areaPx = 0;
    };
    std::vector<Stranger> m_strangers;
};

} // namespace odo
