// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace odo {

/// A convex polygon in a plane, corners anticlockwise.
using ConvexPolygon = std::vector<Eigen::Vector2d>;

/// Positive where the corners run anticlockwise; of any polygon.
double signedArea(std::span<const Eigen::Vector2d> polygon);

/// What of a polygon lies outside another one, in convex pieces that meet at their edges only.
std::vector<ConvexPolygon> outsideOf(const ConvexPolygon &hole, const ConvexPolygon &polygon);

} // namespace odo
