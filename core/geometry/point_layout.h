// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace odo {

/// How far the best four of some points are from being collinear.
struct Spread
{
    double flatness =
        0; ///< smallest height of a triangle of any three of the best four, over the extent of all points
    std::array<int, 3> flattest{}; ///< the three points of that triangle
};

/// The largest distance between two of the points' extremes.
double extentOf(const std::vector<Eigen::Vector2d> &points);

/// Two points nearer to one another than 1e-4 of the extent, if there are any.
std::optional<std::array<int, 2>> coincidentPoints(const std::vector<Eigen::Vector2d> &points);

/// The four points whose flattest triangle is the least flat. Of more than 16 points, 16 are tried (extremes
/// in eight directions and an even sample). Needs four points. enough: a flatness at which the search ends,
/// for callers who only ask whether the points are that spread.
Spread widestQuadrilateral(const std::vector<Eigen::Vector2d> &points,
                           double enough = std::numeric_limits<double>::infinity());

} // namespace odo
