// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

namespace odo {

/// A rotation followed by a translation, named targetFromSource: pointInTarget = targetFromSource *
/// pointInSource. Metres. A plain value.
struct RigidTransform
{
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Eigen::Vector3d operator*(const Eigen::Vector3d &pointInSource) const;
    RigidTransform operator*(const RigidTransform &other) const;
    RigidTransform inverse() const;
};

/// A position on a horizontal plane of the world, with its uncertainty. Metres.
struct FloorPosition
{
    Eigen::Vector2d pointInWorld = Eigen::Vector2d::Zero();
    /// m², from the pixel alone: independent from frame to frame.
    Eigen::Matrix2d pixelCovariance = Eigen::Matrix2d::Zero();
    /// m², from the camera's pose and its lens: common to all frames.
    Eigen::Matrix2d calibrationCovariance = Eigen::Matrix2d::Zero();
    /// d(pointInWorld)/d(height): how an error of the height shifts it.
    Eigen::Vector2d displacementPerMetreHeight = Eigen::Vector2d::Zero();
};

/// Derivative of a camera's fitted pose by the lens that it was fitted with: rows as FloorView's
/// poseCovariance, a column each of (fx, fy, cx, cy, distortion...).
using PoseByIntrinsics = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// One camera registered to the floor: its intrinsics, its pose, and the covariance of both.
///
/// Whoever fits a pose with a wrong lens gets a wrong pose, and on the floor between the markers the two
/// errors cancel in part. So the errors of pose p and lens l are treated jointly, δp = ε + G·δl with ε of
/// poseCovariance and G = poseByIntrinsics: cov(p) = P + GΣGᵀ, cov(p, l) = GΣ, cov(l) = Σ, and a floor point
/// has P_x + KΣKᵀ with K = (dx/dp)·G + dx/dl (first order; the usual elimination of nuisance parameters).
///
/// World: X along O→U, Y towards V, Z up, right-handed, floor at z = 0. Immutable, safe to share between
/// threads.
class FloorView
{
public:
    /// poseCovariance: 6×6 of (rotation vector of a left-applied perturbation of the camera's axes, in
    /// radians, in the world frame; then camera position, in metres, in the world frame); zero where unknown.
    /// It is what the pose would have if the lens were exact. poseByIntrinsics (6 × (4 + the number of
    /// coefficients)): how the pose follows the lens. Without it, or without a covariance in the camera's
    /// intrinsics, they count as exact.
    FloorView(CameraModel camera, RigidTransform worldFromCamera, Eigen::Matrix<double, 6, 6> poseCovariance,
              const PoseByIntrinsics &poseByIntrinsics = PoseByIntrinsics(6, 0));

    /// The same camera, which may have been turned meanwhile: by angles with these standard deviations about
    /// its optical axis (roll) and about each axis across it, in radians.
    FloorView perhapsTurned(double sigmaRollRad, double sigmaAcrossRad) const;

    const CameraModel &camera() const { return m_camera; }
    const RigidTransform &worldFromCamera() const { return m_worldFromCamera; }
    const RigidTransform &cameraFromWorld() const { return m_cameraFromWorld; }
    const Eigen::Matrix<double, 6, 6> &poseCovariance() const { return m_poseCovariance; }
    Eigen::Vector3d cameraInWorld() const { return m_worldFromCamera.translation; }

    /// Where the ray of a pixel meets the plane z = heightM; nullopt at or beyond the horizon, or within 1°
    /// of it.
    std::optional<Eigen::Vector2d> floorFromPixel(const Eigen::Vector2d &pixel, double heightM) const;

    /// How the errors of the lens reach the floor is known.
    bool hasIntrinsicsPart() const { return m_jointCovariance.rows() > 6; }

    /// As floorFromPixel, with covariances propagated to first order.
    std::optional<FloorPosition> locate(const Eigen::Vector2d &pixel, const Eigen::Matrix2d &pixelCovariance,
                                        double heightM) const;

    /// Covariance of the calibration errors at two positions of the plane z = heightM: E[δa·δbᵀ], m². For a =
    /// b it is the calibrationCovariance there. nullopt if one is not visible.
    std::optional<Eigen::Matrix2d> sharedCovariance(const Eigen::Vector2d &a, const Eigen::Vector2d &b,
                                                    double heightM) const;

    /// Pixel of a world point; nullopt behind the camera or where the lens model folds. May lie outside the
    /// image.
    std::optional<Eigen::Vector2d> pixelFromWorld(const Eigen::Vector3d &pointInWorld) const;
    /// As before, with the derivative of the pixel by the point.
    std::optional<Eigen::Vector2d> pixelFromWorld(const Eigen::Vector3d &pointInWorld,
                                                  Eigen::Matrix<double, 2, 3> &pixelByWorld) const;

private:
    /// Derivatives about a point: of it in its plane by the pixel, and of its pixel by point and calibration.
    struct Slopes
    {
        Eigen::Matrix2d pointByPixel;
        Eigen::Matrix<double, 2, 3> pixelByWorld;
        Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, 18> pixelByJoint;
    };
    std::optional<Slopes> slopesAt(const Eigen::Vector3d &pointInWorld) const;

    CameraModel m_camera;
    RigidTransform m_worldFromCamera, m_cameraFromWorld;
    Eigen::Matrix<double, 6, 6> m_poseCovariance;
    Eigen::MatrixXd m_jointCovariance; ///< of (pose, lens); 6×6, of the pose alone, where the lens is exact
};

} // namespace odo
