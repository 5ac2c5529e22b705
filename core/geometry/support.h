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

/// Whether a place lies within all support lines, or at most so far beyond one. Pure.
bool isWithinSupport(const std::vector<float> &support, const Eigen::Vector2d &about, const Eigen::Vector2d &place, double beyondPx = 0);

/// The polygon that a support function bounds: the points p with n·(p − about) ≤ support in every direction. Its corners in pixels, in the order of
/// the directions, none twice. It contains the region's convex hull and touches each of its support lines. Empty where the lines leave no area
/// between them, for fewer or more numbers than there are directions, and for numbers that are not finite. Pure.
std::vector<Eigen::Vector2d> supportPolygon(const std::vector<float> &support, const Eigen::Vector2d &about);

} // namespace odo
