// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/floor_positions.h"

#include <optional>
#include <vector>

namespace odo {

/// Which solid a robot is, and where each view saw it.
struct FoundSolid
{
    SolidShape shape;
    double sigmaMiddleM = 0;                 ///< of the height of its middle
    std::vector<std::vector<Sighting>> seen; ///< of each observation of each view
};

/// The simplest solid that explains the outlines of all views: a box or a cylinder (estimateShape), or, where outlines were measured by their support, one of several levels
/// (fitLevels), with what they tell beyond that (learnReach). nullopt: none explains them. Pure.
std::optional<FoundSolid> findSolid(const std::vector<ViewTrack> &views, const RobotShape &told);

/// How badly the best solid of several levels explains the outlines of all views, in units of half a pixel; nullopt: they were not measured by their support, or too few of
/// them show all of a robot. Pure.
std::optional<double> misfitOfOutlines(const std::vector<ViewTrack> &views, const RobotShape &told);

/// The share of the outlines, but for those that the picture's edge cuts, that are the solid's; 0 where no solid was found, 1 for a mark on top of a robot of a told height.
double explainedShare(const std::vector<ViewTrack> &views, const RobotShape &told);

} // namespace odo
