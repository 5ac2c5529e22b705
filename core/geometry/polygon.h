// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace odo {

/// Adds a point to a chain, those of `points` from `first` on: what comes in order along a line of which the
/// hull lies to one side. In it stay those that the hull may have as corners. turn: 1 or −1, to which side
/// the hull turns along the chain; 1: from x to y.
void addToChain(std::vector<Eigen::Vector2d> &points, std::size_t first, double turn,
                const Eigen::Vector2d &point);

/// The corners of the smallest convex polygon around points, anticlockwise where y points up, by the monotone
/// chain (A. M. Andrew 1979). At least three points that do not lie on one line. Pure.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);

/// Area, centroid and second central moments of a region of the picture. Pixels.
struct RegionMoments
{
    double areaPx2 = 0;
    Eigen::Vector2d centrePx = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariancePx2 = Eigen::Matrix2d::Zero();
};

/// Exact for a polygon with its corners in order, in either orientation (Green's theorem; Steger 1996, "On
/// the calculation of arbitrary moments of polygons"). No area for fewer than three corners.
RegionMoments polygonMoments(const std::vector<Eigen::Vector2d> &corners);

} // namespace odo
