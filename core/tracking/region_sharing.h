// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/blob_finder.h"

#include <vector>

namespace odo {

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

/// A robot's outline as a whole, to be laid over a region that it shares with others. In chroma samples.
struct Silhouette
{
    const RegionMask *mask = nullptr;                    ///< as seen when it was alone
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();    ///< of the mask's region, as it was then
    Eigen::Vector2d predicted = Eigen::Vector2d::Zero(); ///< where that centre should be now
};

/// Lays the silhouettes so that together they explain a region: as much of it as possible covered by at least
/// one, as little as possible covered outside. From the predicted places, by coordinate descent over whole
/// samples, held back by a weak pull to the prediction. Gives the centres, in the order given.
std::vector<Eigen::Vector2d> laySilhouettes(const RegionMask &region,
                                            const std::vector<Silhouette> &silhouettes);

} // namespace odo
