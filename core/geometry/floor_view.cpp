// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/floor_view.h"

#include "core/geometry/cross_matrix.h"

#include <Eigen/LU>
#include <cmath>

namespace odo {

Eigen::Vector3d RigidTransform::operator*(const Eigen::Vector3d &pointInSource) const
{
    return rotation * pointInSource + translation;
}

RigidTransform RigidTransform::operator*(const RigidTransform &other) const
{
    return {(rotation * other.rotation).normalized(), rotation * other.translation + translation};
}

RigidTransform RigidTransform::inverse() const
{
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, -(back * translation)};
}

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double sineOfGrazing = 0.017452406437283512; // 1°: nearer to the horizon a pixel covers metres

/// Of (pose, lens), where the pose follows the lens.
Eigen::MatrixXd jointCovariance(const Eigen::Matrix<double, 6, 6> &pose, const Eigen::MatrixXd &lens,
                                const PoseByIntrinsics &poseByIntrinsics)
{
    if (lens.size() == 0 || poseByIntrinsics.cols() != lens.rows() || !poseByIntrinsics.allFinite())
        return pose;
    Eigen::MatrixXd joint(6 + lens.rows(), 6 + lens.rows());
    const Eigen::MatrixXd together = poseByIntrinsics * lens;
    joint << pose + together * poseByIntrinsics.transpose(), together, together.transpose(), lens;
    return joint;
}

} // namespace

FloorView::FloorView(CameraModel camera, RigidTransform worldFromCamera,
                     Eigen::Matrix<double, 6, 6> poseCovariance, const PoseByIntrinsics &poseByIntrinsics)
    : m_camera(std::move(camera)), m_worldFromCamera(std::move(worldFromCamera)),
      m_cameraFromWorld(m_worldFromCamera.inverse()), m_poseCovariance(std::move(poseCovariance)),
      m_jointCovariance(jointCovariance(m_poseCovariance, m_camera.intrinsics().covariance, poseByIntrinsics))
{
}

FloorView FloorView::perhapsTurned(double sigmaRollRad, double sigmaAcrossRad) const
{
    const Vector3d axis = m_worldFromCamera.rotation * Vector3d::UnitZ();
    const Eigen::Matrix3d roll = axis * axis.transpose(), all = Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d turn =
        sigmaRollRad * sigmaRollRad * roll + sigmaAcrossRad * sigmaAcrossRad * (all - roll);
    FloorView turned = *this;
    turned.m_poseCovariance.topLeftCorner<3, 3>() += turn;
    turned.m_jointCovariance.topLeftCorner<3, 3>() += turn;
    return turned;
}

std::optional<Vector2d> FloorView::floorFromPixel(const Vector2d &pixel, double heightM) const
{
    const auto direction = m_camera.unproject(pixel);
    if (!direction)
        return std::nullopt;
    const Vector3d ray = m_worldFromCamera.rotation * direction->normalized();
    const double climb = heightM - m_worldFromCamera.translation.z();
    // The plane must lie ahead on the ray: below a camera above it, above one that is lower.
    if (!(std::abs(ray.z()) > sineOfGrazing) || !(climb * ray.z() > 0))
        return std::nullopt;
    return Vector2d(m_worldFromCamera.translation.head<2>() + ray.head<2>() * (climb / ray.z()));
}

std::optional<FloorView::Slopes> FloorView::slopesAt(const Vector3d &point) const
{
    const Vector3d fromCamera = point - m_worldFromCamera.translation;
    Eigen::Matrix<double, 2, 3> pixelByPoint;
    const Vector3d pointInCamera = m_cameraFromWorld * point;
    if (!m_camera.project(pointInCamera, pixelByPoint))
        return std::nullopt;
    // The pixel is a function of point, rotation, camera position and lens; it stays where it is, so by the
    // implicit function theorem each derivative of the point is the negative quotient of the pixel's
    // derivatives.
    Slopes slopes;
    slopes.pixelByWorld = pixelByPoint * m_cameraFromWorld.rotation.toRotationMatrix();
    slopes.pointByPixel = slopes.pixelByWorld.leftCols<2>().inverse();
    if (!slopes.pointByPixel.allFinite())
        return std::nullopt;
    slopes.pixelByJoint.resize(2, m_jointCovariance.rows());
    slopes.pixelByJoint.leftCols<3>() = slopes.pixelByWorld * crossMatrix(fromCamera);
    slopes.pixelByJoint.middleCols<3>(3) = -slopes.pixelByWorld;
    if (hasIntrinsicsPart())
        slopes.pixelByJoint.rightCols(slopes.pixelByJoint.cols() - 6) =
            m_camera.pixelByIntrinsics(pointInCamera);
    return slopes;
}

std::optional<FloorPosition> FloorView::locate(const Vector2d &pixel, const Eigen::Matrix2d &pixelCovariance,
                                               double heightM) const
{
    const auto floor = floorFromPixel(pixel, heightM);
    const auto slopes = floor ? slopesAt({floor->x(), floor->y(), heightM}) : std::nullopt;
    if (!slopes)
        return std::nullopt;
    const Eigen::Matrix2d &pointByPixel = slopes->pointByPixel;
    const Eigen::Matrix2d pixelCalibration = slopes->pixelByJoint.lazyProduct(m_jointCovariance)
                                                 .eval()
                                                 .lazyProduct(slopes->pixelByJoint.transpose());
    return FloorPosition{*floor, pointByPixel * pixelCovariance * pointByPixel.transpose(),
                         pointByPixel * pixelCalibration * pointByPixel.transpose(),
                         -pointByPixel * slopes->pixelByWorld.col(2)};
}

std::optional<Eigen::Matrix2d> FloorView::sharedCovariance(const Vector2d &a, const Vector2d &b,
                                                           double heightM) const
{
    const auto atA = slopesAt({a.x(), a.y(), heightM}), atB = slopesAt({b.x(), b.y(), heightM});
    if (!atA || !atB)
        return std::nullopt;
    const Eigen::Matrix2d pixels =
        atA->pixelByJoint.lazyProduct(m_jointCovariance).eval().lazyProduct(atB->pixelByJoint.transpose());
    return Eigen::Matrix2d(atA->pointByPixel * pixels * atB->pointByPixel.transpose());
}

std::optional<Vector2d> FloorView::pixelFromWorld(const Vector3d &pointInWorld) const
{
    return m_camera.project(m_cameraFromWorld * pointInWorld);
}

std::optional<Vector2d> FloorView::pixelFromWorld(const Vector3d &pointInWorld,
                                                  Eigen::Matrix<double, 2, 3> &pixelByWorld) const
{
    const auto pixel = m_camera.project(m_cameraFromWorld * pointInWorld, pixelByWorld);
    pixelByWorld *= m_cameraFromWorld.rotation.toRotationMatrix();
    return pixel;
}

} // namespace odo
