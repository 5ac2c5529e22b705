// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace odo {

/// The corners of the smallest convex polygon around points, anticlockwise where y points up, by the monotone chain (A. M. Andrew 1979). At
/// least three points that do not lie on one line. Pure.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);

} // namespace odo
