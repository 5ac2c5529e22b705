// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/intrinsics_influence.h"

#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/plane_pose.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace odo {

std::optional<MarkerDerivatives> markerDerivatives(const CameraModel &camera,
                                                   const RigidTransform &worldFromCamera,
                                                   std::span<const Eigen::Vector2d> markersOnFloor)
{
    const auto markers = static_cast<Eigen::Index>(markersOnFloor.size());
    const auto values = static_cast<Eigen::Index>(4 + camera.intrinsics().distortion.size());
    const Eigen::Matrix3d cameraAxes = worldFromCamera.rotation.conjugate().toRotationMatrix();
    MarkerDerivatives derivatives{Eigen::MatrixXd(2 * markers, 6), Eigen::MatrixXd(2 * markers, values)};
    for (Eigen::Index i = 0; i < markers; ++i) {
        const Eigen::Vector2d &marker = markersOnFloor[static_cast<std::size_t>(i)];
        const Eigen::Vector3d fromCamera =
            Eigen::Vector3d(marker.x(), marker.y(), 0) - worldFromCamera.translation;
        Eigen::Matrix<double, 2, 3> pixelByPoint;
        if (!camera.project(cameraAxes * fromCamera, pixelByPoint))
            return std::nullopt;
        const Eigen::Matrix<double, 2, 3> pixelByWorld = pixelByPoint * cameraAxes;
        for (int axis = 0; axis < 3; ++axis)
            derivatives.byPose.block<2, 1>(2 * i, axis) =
                pixelByWorld * fromCamera.cross(Eigen::Vector3d::Unit(axis));
        derivatives.byPose.block<2, 3>(2 * i, 3) = -pixelByWorld;
        derivatives.byIntrinsics.middleRows<2>(2 * i) = camera.pixelByIntrinsics(cameraAxes * fromCamera);
    }
    return derivatives;
}

PoseByIntrinsics poseByIntrinsics(const CameraModel &camera, const RigidTransform &worldFromCamera,
                                  std::span<const Eigen::Vector2d> markersOnFloor)
{
    const auto derivatives = markerDerivatives(camera, worldFromCamera, markersOnFloor);
    if (!derivatives || markersOnFloor.empty())
        return PoseByIntrinsics(6, 0);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(derivatives->byPose);
    if (factors.rank() < 6)
        return PoseByIntrinsics(6, 0);
    return -factors.solve(derivatives->byIntrinsics);
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

std::vector<Eigen::Vector2d> markersOnFloorOf(const FloorRegistration &registration,
                                              const CameraModel &camera,
                                              const std::vector<MarkerPixel> &pixels)
{
    const FloorView exact(camera, registration.worldFromCamera, registration.poseCovariance);
    std::vector<Eigen::Vector2d> positions;
    for (const Eigen::Vector2d &pixel : usedPixels(registration, pixels)) {
        if (const auto floorPoint = exact.floorFromPixel(pixel, 0))
            positions.push_back(*floorPoint);
    }
    return positions;
}

FloorView floorViewOf(const FloorRegistration &registration, const CameraModel &camera,
                      const std::vector<MarkerPixel> &pixels)
{
    if (camera.intrinsics().covariance.size() == 0)
        return FloorView(camera, registration.worldFromCamera, registration.poseCovariance);
    return FloorView(camera, registration.worldFromCamera, registration.poseCovariance,
                     poseByIntrinsics(camera, registration.worldFromCamera,
                                      markersOnFloorOf(registration, camera, pixels)));
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

namespace {

using Eigen::Vector2d;

constexpr double heightM = 2, longSideM = 3, shortSideM = 2;
constexpr double nearestM = 0.3, farthestM = 60, stepFactor = 1.05;
constexpr double margin = 0.03;      // of the image's shorter side, free about the floor
constexpr int across = 12, deep = 8; // fields of the grid

/// Width and depth of the floor as the camera sees it.
Vector2d extentFor(const CameraModel &camera)
{
    const Intrinsics &lens = camera.intrinsics();
    return lens.widthPx >= lens.heightPx ? Vector2d(longSideM, shortSideM) : Vector2d(shortSideM, longSideM);
}

std::array<Vector2d, 4> cornersOf(const Vector2d &extent)
{
    return {Vector2d(0, 0), Vector2d(extent.x(), 0), extent, Vector2d(0, extent.y())};
}

/// Before the middle of the near edge, aimed between the near and the far edge.
RigidTransform positionAt(double distanceM, const Vector2d &extent)
{
    const double pitch = 0.5 * (std::atan2(heightM, distanceM) + std::atan2(heightM, distanceM + extent.y()));
    Eigen::Matrix3d axes;
    axes << 1, 0, 0, 0, -std::sin(pitch), std::cos(pitch), 0, -std::cos(pitch), -std::sin(pitch);
    RigidTransform worldFromCamera;
    worldFromCamera.rotation = Eigen::Quaterniond(axes);
    worldFromCamera.translation = {0.5 * extent.x(), -distanceM, heightM};
    return worldFromCamera;
}

bool seesAll(const CameraModel &camera, const RigidTransform &worldFromCamera, const Vector2d &extent)
{
    const Intrinsics &lens = camera.intrinsics();
    const double free = margin * std::min(lens.widthPx, lens.heightPx);
    const RigidTransform cameraFromWorld = worldFromCamera.inverse();
    return std::ranges::all_of(cornersOf(extent), [&](const Vector2d &corner) {
        const auto pixel = camera.project(cameraFromWorld * Eigen::Vector3d(corner.x(), corner.y(), 0));
        return pixel && pixel->x() >= free && pixel->y() >= free && pixel->x() <= lens.widthPx - 1 - free &&
               pixel->y() <= lens.heightPx - 1 - free;
    });
}

Message whereOf(int column, int row)
{
    const MessageText *const positions[3][3] = {
        {&ODO_TEXT("calibration.near_left_corner", "in the near left corner"),
         &ODO_TEXT("calibration.near_edge", "at the near edge"),
         &ODO_TEXT("calibration.near_right_corner", "in the near right corner")},
        {&ODO_TEXT("calibration.left_edge", "at the left edge"), &ODO_TEXT("calibration.inside", "inside"),
         &ODO_TEXT("calibration.right_edge", "at the right edge")},
        {&ODO_TEXT("calibration.far_left_corner", "in the far left corner"),
         &ODO_TEXT("calibration.far_edge", "at the far edge"),
         &ODO_TEXT("calibration.far_right_corner", "in the far right corner")}};
    const auto third = [](int at, int last) { return at <= 1 ? 0 : at >= last - 1 ? 2 : 1; };
    return *positions[third(row, deep)][third(column, across)];
}

/// errorM: of a floor position; nullopt where it has none.
std::optional<FloorExpectation>
overTheFloor(const Vector2d &extent, const std::function<std::optional<double>(const Vector2d &)> &errorM)
{
    FloorExpectation expectation;
    for (int row = 0; row <= deep; ++row) {
        for (int column = 0; column <= across; ++column) {
            const auto error = errorM({extent.x() * column / across, extent.y() * row / deep});
            if (!error || !std::isfinite(*error))
                return std::nullopt;
            if (2 * column == across && 2 * row == deep)
                expectation.middleM = *error;
            if (*error < expectation.worstM)
                continue;
            expectation.worstM = *error;
            expectation.worstWhere = whereOf(column, row);
        }
    }
    return expectation;
}

} // namespace

std::optional<FloorView> typicalTestbed(const CameraModel &camera)
{
    const Vector2d extent = extentFor(camera);
    for (double distanceM = nearestM; distanceM < farthestM; distanceM *= stepFactor) {
        const RigidTransform floorPoint = positionAt(distanceM, extent);
        if (!seesAll(camera, floorPoint, extent))
            continue;
        return FloorView(camera, floorPoint, Eigen::Matrix<double, 6, 6>::Zero(),
                         poseByIntrinsics(camera, floorPoint, cornersOf(extent)));
    }
    return std::nullopt;
}

Message typicalTestbedWords()
{
    return ODO_TEXT("calibration.typical_testbed", "a %1 × %2 floor seen from %3 above")(
        quantity(longSideM, 0, "m"), quantity(shortSideM, 0, "m"), quantity(heightM, 0, "m"));
}

std::optional<FloorExpectation> expectedOnFloor(const Intrinsics &intrinsics)
{
    const auto camera = CameraModel::create(intrinsics);
    if (!camera || intrinsics.covariance.size() == 0)
        return std::nullopt;
    const auto view = typicalTestbed(*camera);
    if (!view || !view->hasIntrinsicsPart())
        return std::nullopt;
    return overTheFloor(extentFor(*camera), [&](const Vector2d &floorPoint) -> std::optional<double> {
        const auto pixel = view->pixelFromWorld({floorPoint.x(), floorPoint.y(), 0});
        const auto seen = pixel ? view->locate(*pixel, Eigen::Matrix2d::Zero(), 0) : std::nullopt;
        return seen ? std::optional(largestSigmaM(*seen)) : std::nullopt;
    });
}

std::optional<FloorExpectation> apartOnFloor(const Intrinsics &one, const Intrinsics &other)
{
    const auto camera = CameraModel::create(one), second = CameraModel::create(other);
    const auto view = camera ? typicalTestbed(*camera) : std::nullopt;
    if (!view || !second)
        return std::nullopt;
    const Vector2d extent = extentFor(*camera);
    std::vector<PointPair> markers;
    for (const Vector2d &corner : cornersOf(extent)) {
        const auto pixel = view->pixelFromWorld({corner.x(), corner.y(), 0});
        if (!pixel)
            return std::nullopt;
        markers.push_back({corner, *pixel, {}});
    }
    const auto pose = fitPlanePose(markers, *second, FocalLength::Known);
    if (!pose)
        return std::nullopt;
    const FloorView secondView(*second, pose->worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
    return overTheFloor(extent, [&](const Vector2d &floorPoint) -> std::optional<double> {
        const auto pixel = view->pixelFromWorld({floorPoint.x(), floorPoint.y(), 0});
        const auto seen = pixel ? secondView.floorFromPixel(*pixel, 0) : std::nullopt;
        return seen ? std::optional((*seen - floorPoint).norm()) : std::nullopt;
    });
}

} // namespace odo
