// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/camera_pair.h"
#include "core/calibration/chained_registration.h"

namespace odo {

/// A camera's pose on the floor, with its covariance as FloorView says, that of the lens included.
struct PoseOnFloor
{
    RigidTransform worldFromCamera;
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// Of a registration. camera: the lens it was made with; pixels: those it was made from.
PoseOnFloor poseOnFloor(const FloorRegistration &registration, const CameraModel &camera,
                        const std::vector<MarkerPixel> &pixels);

/// The relation from B to A, with its covariance in A's axes.
CameraPair reversed(const CameraPair &pair);

/// Where camera B is on the floor by where A is. The errors of both count as independent (both hold A's
/// lens).
PoseOnFloor poseByRelation(const PoseOnFloor &a, const CameraPair &pair);

/// Registers a camera to the floor by such a pose, without markers. Its points are floor points where the
/// image shows the floor, with the pixels that the pose gives them: they stand for markers and have no
/// errors. The whole uncertainty is in the pose covariance. Undetermined where fewer than four such points
/// exist, and where the floor would be known worse than 3 % of their extent.
Result<ChainedRegistration> registerByPose(const PoseOnFloor &pose, const Message &referenceName,
                                           const CameraModel &camera, double rmsPx);

/// How far two poses of one camera differ.
struct PoseDifference
{
    double distanceM = 0, distanceSigmaM = 0; ///< and its σ along that direction
    double angle = 0, angleSigma = 0;         ///< radians, the same
    bool isSignificant = false;               ///< beyond 99.9 % of χ² of six degrees of freedom
};
PoseDifference differenceOf(const PoseOnFloor &one, const PoseOnFloor &other);

} // namespace odo
