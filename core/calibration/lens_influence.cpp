// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/lens_influence.h"

#include "core/calibration/floor_registration.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace odo {

PoseByLens poseByLens(const CameraModel &camera, const RigidTransform &worldFromCamera,
                      std::span<const Eigen::Vector2d> markersOnFloor)
{
    const auto markers = static_cast<Eigen::Index>(markersOnFloor.size());
    const auto values = static_cast<Eigen::Index>(4 + camera.intrinsics().distortion.size());
    const Eigen::Matrix3d cameraAxes = worldFromCamera.rotation.conjugate().toRotationMatrix();
    Eigen::MatrixXd byPose(2 * markers, 6), byLens(2 * markers, values);
    for (Eigen::Index i = 0; i < markers; ++i) {
        const Eigen::Vector2d &marker = markersOnFloor[static_cast<std::size_t>(i)];
        const Eigen::Vector3d fromCamera =
            Eigen::Vector3d(marker.x(), marker.y(), 0) - worldFromCamera.translation;
        Eigen::Matrix<double, 2, 3> pixelByPoint;
        if (!camera.project(cameraAxes * fromCamera, pixelByPoint))
            return PoseByLens(6, 0);
        const Eigen::Matrix<double, 2, 3> pixelByWorld = pixelByPoint * cameraAxes;
        for (int axis = 0; axis < 3; ++axis)
            byPose.block<2, 1>(2 * i, axis) = pixelByWorld * fromCamera.cross(Eigen::Vector3d::Unit(axis));
        byPose.block<2, 3>(2 * i, 3) = -pixelByWorld;
        byLens.middleRows<2>(2 * i) = camera.pixelByLens(cameraAxes * fromCamera);
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(byPose);
    if (markers == 0 || factors.rank() < 6)
        return PoseByLens(6, 0);
    return -factors.solve(byLens);
}

namespace {

/// Of the pixels those that the registration was made from.
std::vector<Eigen::Vector2d> usedPixels(const FloorRegistration &registration,
                                        const std::vector<MarkerPixel> &pixels)
{
    std::vector<Eigen::Vector2d> used;
    for (const MarkerPixel &pixel : pixels) {
        if (std::ranges::find(registration.markers, pixel.label, &MarkerError::label) !=
            registration.markers.end())
            used.push_back(pixel.pixel);
    }
    return used;
}

} // namespace

FloorView floorViewOf(const FloorRegistration &registration, const CameraModel &camera,
                      const std::vector<MarkerPixel> &pixels)
{
    FloorView exact(camera, registration.worldFromCamera, registration.poseCovariance);
    if (camera.intrinsics().covariance.size() == 0)
        return exact;
    std::vector<Eigen::Vector2d> places;
    for (const Eigen::Vector2d &pixel : usedPixels(registration, pixels)) {
        if (const auto place = exact.floorFromPixel(pixel, 0))
            places.push_back(*place);
    }
    return FloorView(camera, registration.worldFromCamera, registration.poseCovariance,
                     poseByLens(camera, registration.worldFromCamera, places));
}

double largestSigmaM(const FloorPosition &position)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(position.calibrationCovariance);
    return std::sqrt(std::max(0.0, axes.eigenvalues().y()));
}

double floorSigmaM(const FloorRegistration &registration, const CameraModel &camera,
                   const std::vector<MarkerPixel> &pixels)
{
    const FloorView view = floorViewOf(registration, camera, pixels);
    double sigmaM = 0;
    for (const Eigen::Vector2d &pixel : usedPixels(registration, pixels)) {
        if (const auto seen = view.locate(pixel, Eigen::Matrix2d::Zero(), 0))
            sigmaM = std::max(sigmaM, largestSigmaM(*seen));
    }
    return sigmaM;
}

} // namespace odo
