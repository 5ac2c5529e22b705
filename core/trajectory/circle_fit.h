// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace odo {

struct CircleFit
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radiusM = 0;
    double sigmaRadiusM = 0; ///< of the points' scatter alone; the calibration's error of scale is not in it
    double rmsM = 0;         ///< of the points' distances from the circle
};

/// The circle with the least squared distances from points in order along a path (algebraic start: Kåsa 1976;
/// then Gauss–Newton on the distances). σ from the scatter of the distances; neighbours' errors go together,
/// so they count as fewer: by 1 + 2Σρₖ of the distances' autocorrelation up to its first change of sign.
/// nullopt when the path is no circle: fewer than ten points, less than a third of a turn, or distances of
/// more than 3 % of the radius.
std::optional<CircleFit> fitCircle(std::span<const Eigen::Vector2d> path);

} // namespace odo
