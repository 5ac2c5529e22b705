// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/body_outline.h"
#include "core/trajectory/internal/level_fit.h"

#include <optional>
#include <vector>

namespace odo {

/// What outlines show of a body beyond the solid of levels that was fitted to them.
struct LearnedReach
{
    OutlineDifference outlines;
    /// forward and left of the solid's position: the middle of the body's footprint
    Eigen::Vector2d middleM = Eigen::Vector2d::Zero();
    /// of where that middle is, along and across the heading
    double sigmaForwardM = 0, sigmaLeftM = 0;
    double amplitudeM = 0; ///< how far the body and the solid usually differ
};

/// Learns how the body's convex hull differs from the solid, whatever it looks like: a Gaussian process over
/// the directions on the body (smooth over 15°, nearly alike to the left and to the right), fitted by linear
/// least squares together with a shift of each position. How much they differ is what makes the outlines
/// likeliest (marginal likelihood; Rasmussen and Williams, Gaussian Processes for Machine Learning,
/// 2006, 5.4). With it goes by how much all outlines are drawn too wide. What the outlines leave open of all
/// this is in the σ, which takes no body for known to better than two millimetres. given: its length and
/// width are kept. nullopt: no outline was measured by its support. Pure.
std::optional<LearnedReach> learnReach(const std::vector<CommonOutlines> &times, const LevelFit &fit,
                                       const RobotShape &given);

} // namespace odo
