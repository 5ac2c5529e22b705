// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"

#include <Eigen/Core>
#include <vector>

namespace odo {

/// Area, centroid and second central moments of a closed outline, in luma pixels.
struct OutlineMoments
{
    double area = 0;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
};

/// Exact for a polygon, in either orientation (Green's theorem; Steger 1996, "On the calculation of arbitrary
/// moments of polygons"). Area 0 for fewer than three points.
OutlineMoments momentsOf(const std::vector<Eigen::Vector2d> &polygon);

/// The ellipse about a centre that has these second moments.
Ellipse ellipseOf(const Eigen::Vector2d &centrePx, const Eigen::Matrix2d &covariance);

} // namespace odo
