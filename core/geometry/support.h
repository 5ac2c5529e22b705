// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace odo {

/// Directions of the picture in which the extent of a region is measured: direction k stands at 2πk/24 from the x axis toward y (down).
constexpr std::size_t supportDirections = 24;
Eigen::Vector2d supportDirection(std::size_t k);

/// The support function of a region in each direction: how far it, and with it its convex hull, reaches from a place, max over the points of
/// n·(point − about). Pixels. points: at least one. Pure.
std::vector<float> supportOf(const std::vector<Eigen::Vector2d> &points, const Eigen::Vector2d &about);

} // namespace odo
