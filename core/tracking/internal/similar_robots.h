// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/blob_finder.h"
#include "core/tracking/internal/robot_follower.h"

#include <vector>

namespace odo {

/// Follows, in one frame, robots that are near one another in the frame and whose colours do not distinguish
/// their samples. All regions are found once for all of them and assigned at once, by position, size and mean
/// colour. If there are fewer regions than robots, some have merged in the frame: then their last outlines
/// are fitted into the region, and each gets a coarse position of low score; none takes the whole region's
/// centre. Keeps its memory.
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

/// Which robots are which regions, all at once: what several robots of a like colour may be in one frame.
struct SharingProblem
{
    /// alone[robot][region]: half the squared standard deviations of the robot being that region by itself.
    std::vector<std::vector<double>> alone;
    /// together[robot][region]: the same of its being a part of the region, the others' share left open.
    std::vector<std::vector<double>> together;
    std::vector<double> robotAreas, regionAreas; ///< in the same unit
    double costOfNone = 6.0;                     ///< of a robot that is in none of the regions
};

/// The cheapest sharing: for each robot the index of its region, −1 for none; robots with equal indices share
/// one. A shared region must have an area between that of the largest of its robots and that of all of them.
/// Exhaustive with pruning: meant for up to some six robots and regions.
std::vector<int> shareRegions(const SharingProblem &problem);

/// A robot's outline as a whole, to be fitted into a region that it shares with others. In chroma samples.
struct Silhouette
{
    const RegionMask *mask = nullptr;                    ///< as seen when it was alone
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();    ///< of the mask's region, as it was then
    Eigen::Vector2d predicted = Eigen::Vector2d::Zero(); ///< where that centre should be now
};

/// Arranges the silhouettes so that together they explain a region: as much of it as possible covered by at
/// least one, as little as possible covered outside. From the predicted positions, by coordinate descent over
/// whole samples, held back by a weak pull to the prediction. Gives the centres, in the order given.
std::vector<Eigen::Vector2d> laySilhouettes(const RegionMask &region,
                                            const std::vector<Silhouette> &silhouettes);

} // namespace odo
