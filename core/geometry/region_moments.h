// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace odo {

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
