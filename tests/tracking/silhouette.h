// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"
#include "core/tracking/observation.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace odo {

/// Area, centroid and second central moments of a closed polygon, exact (Green's theorem; Steger 1996).
struct PolygonMoments
{
    double area = 0;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};
PolygonMoments exactMoments(std::span<const Eigen::Vector2d> polygon);

/// The outline that a convex robot has in a camera's picture in the middle of a frame's exposure, in luma
/// pixels: the convex hull of its corners, edges bent as the lens bends them.
std::vector<Eigen::Vector2d> silhouette(const SimulatedScene &scene, std::size_t robot, int camera,
                                        std::int64_t frame);

/// Second central moments that an ellipse stands for.
Eigen::Matrix2d covarianceOf(const Ellipse &ellipse);

} // namespace odo
