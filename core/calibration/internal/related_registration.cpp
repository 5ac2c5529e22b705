// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/related_registration.h"

#include "core/base/units.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/geometry/cross_matrix.h"
#include "core/geometry/homography.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr int gridSide = 5;                // points across the image
constexpr double gridMargin = 0.05;        // of the image
constexpr double farthestHeights = 4;      // of the camera's height: beyond, a floor point says little
constexpr double worstRelatedSigma = 0.03; // of the points' extent
constexpr double mostChiSquared = 22.458;  // 99.9 % of six degrees of freedom

double sigmaAlong(const Vector3d &direction, const Matrix3d &covariance)
{
    const Vector3d unit = direction.norm() > 0 ? Vector3d(direction.normalized()) : Vector3d::UnitX();
    return std::sqrt(std::max(0.0, unit.dot(covariance * unit)));
}

/// Pixels over the image that show the floor not too far away.
std::vector<MarkerPixel> floorPixels(const FloorView &view)
{
    const Intrinsics &lens = view.camera().intrinsics();
    std::vector<MarkerPixel> pixels;
    for (int row = 0; row < gridSide; ++row) {
        for (int column = 0; column < gridSide; ++column) {
            const auto at = [](int step, int size) {
                return size * (gridMargin + (1 - 2 * gridMargin) * step / (gridSide - 1)) - 0.5;
            };
            const Vector2d pixel(at(column, lens.widthPx), at(row, lens.heightPx));
            const auto onFloor = view.floorFromPixel(pixel, 0);
            const Vector3d camera = view.cameraInWorld();
            if (onFloor && (*onFloor - camera.head<2>()).norm() < farthestHeights * camera.z())
                pixels.push_back({"p" + std::to_string(pixels.size() + 1), pixel});
        }
    }
    return pixels;
}

tl::unexpected<Error> refuseRelated(Message why, Message advice)
{
    return fail(ErrorCode::Undetermined,
                ODO_TEXT("calibration.not_registered_by_pair", "the camera cannot be registered by the pair"),
                std::move(why), std::move(advice));
}

} // namespace

PoseOnFloor poseOnFloor(const FloorRegistration &registration, const CameraModel &camera,
                        const std::vector<MarkerPixel> &pixels)
{
    PoseOnFloor pose{registration.worldFromCamera, registration.poseCovariance};
    const Eigen::MatrixXd &lens = camera.intrinsics().covariance;
    const auto byIntrinsics = poseByIntrinsics(camera, registration.worldFromCamera,
                                               markersOnFloorOf(registration, camera, pixels));
    if (lens.size() > 0 && byIntrinsics.cols() == lens.rows())
        pose.covariance += byIntrinsics * lens * byIntrinsics.transpose();
    return pose;
}

CameraPair reversed(const CameraPair &pair)
{
    // For a left-applied turn φ and a shift τ of B from A, A from B is turned by −Rᵀφ and shifted by
    // −Rᵀ(τ + t × φ), to first order.
    CameraPair back = pair;
    back.bFromA = pair.bFromA.inverse();
    const Matrix3d turn = pair.bFromA.rotation.toRotationMatrix().transpose();
    Matrix6d change;
    change << -turn, Matrix3d::Zero(), -turn * crossMatrix(pair.bFromA.translation), -turn;
    back.covariance = change * pair.covariance * change.transpose();
    return back;
}

PoseOnFloor poseByRelation(const PoseOnFloor &a, const CameraPair &pair)
{
    const CameraPair back = reversed(pair);
    PoseOnFloor pose{a.worldFromCamera * back.bFromA, Matrix6d::Zero()};
    // world from B = (world from A) · (A from B), each turned from the left.
    const Matrix3d axes = a.worldFromCamera.rotation.toRotationMatrix();
    Matrix6d byA = Matrix6d::Identity(), byRelation;
    byA.bottomLeftCorner<3, 3>() = -crossMatrix(axes * back.bFromA.translation);
    byRelation << axes, Matrix3d::Zero(), Matrix3d::Zero(), axes;
    pose.covariance =
        byA * a.covariance * byA.transpose() + byRelation * back.covariance * byRelation.transpose();
    return pose;
}

Result<ChainedRegistration> registerByPose(const PoseOnFloor &pose, const Message &referenceName,
                                           const CameraModel &camera, double rmsPx)
{
    const FloorView view(camera, pose.worldFromCamera, pose.covariance);
    ChainedRegistration related;
    related.pixels = floorPixels(view);
    if (!(view.cameraInWorld().z() > 0) || related.pixels.size() < 4)
        return refuseRelated(ODO_TEXT("calibration.pair_sees_no_floor", "it would see hardly any floor"),
                             ODO_TEXT("calibration.check_first_registration",
                                      "check the registration of %1 and the pair")(referenceName));
    FloorRegistration &registration = related.registration;
    registration.worldFromCamera = pose.worldFromCamera;
    registration.poseCovariance = pose.covariance;
    registration.intrinsics = camera.intrinsics();
    registration.rmsPx = rmsPx;
    std::vector<Vector2d> positions;
    for (const MarkerPixel &pixel : related.pixels) {
        const auto seen = view.locate(pixel.pixel, Eigen::Matrix2d::Zero(), 0);
        if (!seen)
            continue;
        related.positions.markers.push_back({pixel.label, seen->pointInWorld});
        registration.markers.push_back({pixel.label, 0, 0});
        positions.push_back(seen->pointInWorld);
    }
    registration.floorSigmaM = floorSigmaM(registration, camera, related.pixels);
    const double extent = extentOf(positions);
    if (!(registration.floorSigmaM <= worstRelatedSigma * extent))
        return refuseRelated(ODO_TEXT("calibration.pair_floor_unsure", "the floor uncertainty would be ±%1")(
                                 millimetres(registration.floorSigmaM)),
                             ODO_TEXT("calibration.more_pairs",
                                      "take more pairs, or register %1 better first")(referenceName));
    registration.verdict = registrationVerdict(
        registration.floorSigmaM, extent,
        ODO_TEXT("calibration.related_to", "via %1 and a board that both see; floor uncertainty ±%2")(
            referenceName, millimetres(registration.floorSigmaM)));
    return related;
}

PoseDifference differenceOf(const PoseOnFloor &one, const PoseOnFloor &other)
{
    const Eigen::AngleAxisd turn(other.worldFromCamera.rotation * one.worldFromCamera.rotation.conjugate());
    Vector6d apart;
    apart << turn.angle() * turn.axis(), other.worldFromCamera.translation - one.worldFromCamera.translation;
    const Matrix6d covariance = one.covariance + other.covariance;
    PoseDifference difference;
    difference.angle = turn.angle();
    difference.angleSigma = sigmaAlong(apart.head<3>(), covariance.topLeftCorner<3, 3>());
    difference.distanceM = apart.tail<3>().norm();
    difference.distanceSigmaM = sigmaAlong(apart.tail<3>(), covariance.bottomRightCorner<3, 3>());
    difference.isSignificant = apart.dot(covariance.ldlt().solve(apart)) > mostChiSquared;
    return difference;
}

} // namespace odo
