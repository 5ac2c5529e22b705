// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace odo {

/// A convex polygon in a plane, corners anticlockwise.
using ConvexPolygon = std::vector<Eigen::Vector2d>;

/// The corners of the smallest convex polygon around points (A. M. Andrew 1979).
ConvexPolygon convexHull(std::vector<Eigen::Vector2d> points);

/// What of a polygon lies outside another one, in convex pieces that meet at their edges only.
std::vector<ConvexPolygon> outsideOf(const ConvexPolygon &hole, const ConvexPolygon &polygon);

} // namespace odo
