// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera_model.h"
#include "core/geometry/floor_view.h"
#include "core/geometry/homography.h"

#include <optional>
#include <span>

namespace odo {

/// A camera's pose against a plane z = 0 whose points it sees.
struct PlanePose
{
    CameraModel camera; ///< as given, or with the focal length that was estimated
    RigidTransform worldFromCamera;
    /// Inverse of the normal matrix at unit pixel noise, of (rotation, position) as FloorView's pose
    /// covariance; the focal length is held.
    Eigen::Matrix<double, 6, 6> inverseNormal;
    double rmsPx = 0;   ///< sqrt(mean of squared distances)
    double sigmaPx = 0; ///< of one coordinate, from the residuals and their degrees of freedom
    std::optional<double>
        focalSigmaPx; ///< where the focal length was estimated, at 1 px noise or sigmaPx if larger
};

/// Pose from a homography (plane → viewing rays x/z, y/z): the first two columns are axes, the third the
/// position (Zhang 2000, section 3.1); the nearest rotation by singular values. The camera may come out on
/// either side.
RigidTransform poseFromHomography(const Homography &raysFromPlane);

enum class FocalLength { Known, Free };

/// Fits the pose to plane points (source, metres) and their pixels (target): homography of the undistorted
/// pixels, its decomposition, then Levenberg–Marquardt on the distance in the image. With FocalLength::Free
/// the focal length is estimated too (Zhang 2000, equations 3 and 4), if it is determined to 10 %; otherwise
/// the given one stays. Errors as Homography::estimate, and for pixels that the lens model cannot have made.
/// weights: a matrix for each pair by which its distance in the image is multiplied before it is squared (the
/// inverse root of its covariance); sigmaPx and inverseNormal are then of the weighted distances. Empty: all
/// count alike.
Result<PlanePose> fitPlanePose(std::span<const PointPair> pairs, const CameraModel &camera, FocalLength focal,
                               std::span<const Eigen::Matrix2d> weights = {});

/// As fitPlanePose, from a pose that is nearly right, which saves most of the time. nullopt where a point has
/// no pixel there, or the points do not determine a pose.
std::optional<PlanePose> refinePlanePose(std::span<const PointPair> pairs, const CameraModel &camera,
                                         FocalLength focal, const RigidTransform &worldFromCamera);

} // namespace odo
