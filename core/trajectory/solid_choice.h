// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/geometry/silhouette.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/floor_positions.h"

#include <optional>
#include <vector>

namespace odo {

/// Which solid a robot is, and where each view saw it.
struct FoundSolid
{
    SolidShape shape;
    double sigmaMiddleM = 0;                 ///< of the height of its middle
    std::vector<std::vector<Sighting>> seen; ///< of each observation of each view
    /// of each observation of the first view; a cylinder has none
    std::vector<std::optional<MeasuredHeading>> headings = {};
    /// a box or a cylinder from which the outlines differ by less than their uncertainty
    bool isPlainAndRight = false;
};

/// The simplest solid that explains the outlines of all views: a box or a cylinder (estimateShape), or, where
/// outlines were measured by their support, one of several levels (fitLevels), with what they show beyond
/// that (learnReach). nullopt: none explains them. Pure.
std::optional<FoundSolid> findSolid(const std::vector<ViewTrack> &views, const RobotShape &given);
/// A box or a cylinder only: what views that contradict each other show can bend it less than a form that is
/// learned from them. nullopt: neither explains the outlines.
std::optional<FoundSolid> findPlainSolid(const std::vector<ViewTrack> &views, const RobotShape &given);

/// How badly the best solid of several levels explains the outlines of all views, in units of half a pixel;
/// nullopt: they were not measured by their support, or too few of them show all of a robot. Pure.
std::optional<double> misfitOfOutlines(const std::vector<ViewTrack> &views, const RobotShape &given);

/// The share of the outlines, without those cut by the frame's edge, that are the solid's; 0 where no solid
/// was found, 1 for a mark on top of a robot of a given height.
double explainedShare(const std::vector<ViewTrack> &views, const RobotShape &given);

struct ShapeEstimate
{
    SolidShape shape;
    double sigmaTopM = 0;    ///< of the top's height
    double sigmaMiddleM = 0; ///< of the height of its middle: the unknown clearance below it is in it
    bool heightEstimated = false;
    double misfit =
        0; ///< how well the outlines agree with the solid's, in units of their uncertainty: about 1 is good
};

/// Which solid the outlines of all views are silhouettes of: a box or a cylinder, standing on the floor, or
/// only a plate at the robot's top, or what lies between. One on the floor may have wheels: its clearance is
/// estimated if the outlines show it clearly, and adds to the uncertainty otherwise. A given height and size
/// are kept; the rest is estimated, together with a pose for each of some forty times spread over the run, by
/// weighted least squares of the outlines' centroids, areas and second moments over all views (Ceres,
/// Cauchy's loss against outlines that are hidden in part). The disagreement of the views' positions
/// determines the height, the outlines' forms height and size. σ assumes that all frames of a quarter of the
/// run share the errors of the outlines. nullopt: fewer than five clear outlines. Pure. Beyond this misfit no
/// such solid explains the outlines.
constexpr double worstShapeMisfit = 4;

std::optional<ShapeEstimate> estimateShape(const std::vector<ViewTrack> &views, const RobotShape &given);

} // namespace odo
