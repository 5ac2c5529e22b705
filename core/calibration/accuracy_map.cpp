// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/accuracy_map.h"

#include "core/base/units.h"
#include "core/calibration/plane_pose.h"
#include "core/calibration/wording.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

bool isInPicture(const Vector2d &pixel, const Intrinsics &lens)
{
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() <= lens.widthPx - 0.5 && pixel.y() <= lens.heightPx - 0.5;
}

std::optional<Matrix2d> covarianceAt(const FloorView &view, const Vector3d &place, double sigmaPx)
{
    const auto pixel = view.pixelFromWorld(place);
    if (!pixel || !isInPicture(*pixel, view.camera().intrinsics()))
        return std::nullopt;
    const auto seen = view.locate(*pixel, sigmaPx * sigmaPx * Matrix2d::Identity(), place.z());
    if (!seen)
        return std::nullopt;
    return seen->pixelCovariance + seen->calibrationCovariance;
}

double largestSigma(const Matrix2d &covariance)
{
    return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Matrix2d>(covariance).eigenvalues().y()));
}

tl::unexpected<Error> noCamera(std::string why, std::string advice)
{
    return fail(ErrorCode::InvalidInput, "the planned camera", std::move(why), std::move(advice));
}

/// What a registration by these markers would leave of the pose: σ²(JᵀJ)⁻¹.
Result<Eigen::Matrix<double, 6, 6>> poseCovariance(const FloorView &view, const MarkerLayout &layout, double sigmaPx)
{
    std::vector<PointPair> pairs;
    std::vector<std::string> seen;
    for (const Marker &marker : layout.markers) {
        const auto pixel = view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
        if (!pixel || !isInPicture(*pixel, view.camera().intrinsics()))
            continue;
        pairs.push_back({marker.pointInWorld, *pixel, marker.label});
        seen.push_back(marker.label);
    }
    if (seen.size() < 4)
        return noCamera("from there it would see " + std::to_string(seen.size()) + " of the layout's markers (" +
                            listed(seen) + "), four are needed",
                        "move it back or up, or choose a wider lens");
    const auto pose = fitPlanePose(pairs, view.camera(), FocalLength::Known);
    if (!pose)
        return noCamera("the markers that it would see do not hold it: " + pose.error().why, pose.error().advice);
    return Eigen::Matrix<double, 6, 6>(sigmaPx * sigmaPx * pose->inverseNormal);
}

} // namespace

FloorGrid gridOver(const MarkerLayout &layout, double marginM, int mostAcross)
{
    if (layout.markers.empty() || mostAcross < 2)
        return {};
    Vector2d lower = layout.markers.front().pointInWorld, upper = lower;
    for (const Marker &marker : layout.markers) {
        lower = lower.cwiseMin(marker.pointInWorld);
        upper = upper.cwiseMax(marker.pointInWorld);
    }
    const Vector2d margin = Vector2d::Constant(marginM), size = upper - lower + 2 * margin;
    FloorGrid grid;
    grid.lowerM = lower - margin;
    grid.stepM = std::max(size.maxCoeff() / (mostAcross - 1), 1e-3);
    grid.columns = 1 + static_cast<int>(std::floor(size.x() / grid.stepM + 1e-9));
    grid.rows = 1 + static_cast<int>(std::floor(size.y() / grid.stepM + 1e-9));
    return grid;
}

AccuracyMap accuracyMap(std::span<const FloorView> views, const FloorGrid &grid, double sigmaPx, double heightM)
{
    constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
    const std::size_t places = static_cast<std::size_t>(std::max(0, grid.columns)) * static_cast<std::size_t>(std::max(0, grid.rows));
    AccuracyMap map{grid, std::vector<std::vector<double>>(views.size(), std::vector<double>(places, unseen)),
                    std::vector<double>(places, unseen)};
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2d point = grid.at(column, row);
            Matrix2d information = Matrix2d::Zero();
            for (std::size_t i = 0; i < views.size(); ++i) {
                const auto covariance = covarianceAt(views[i], {point.x(), point.y(), heightM}, sigmaPx);
                if (!covariance)
                    continue;
                map.cameraSigmaM[i][grid.index(column, row)] = largestSigma(*covariance);
                information += covariance->inverse();
            }
            if (information.determinant() > 0)
                map.fusedSigmaM[grid.index(column, row)] = largestSigma(information.inverse());
        }
    }
    return map;
}

Vector2d PlannedCamera::footM() const
{
    const double direction = directionDegrees * EIGEN_PI / 180;
    return aimM + distanceM * Vector2d(std::cos(direction), std::sin(direction));
}

void PlannedCamera::standAt(const Vector2d &footM)
{
    const Vector2d away = footM - aimM;
    distanceM = away.norm();
    if (distanceM > 0) // straight above, the direction stays what it was
        directionDegrees = std::atan2(away.y(), away.x()) * 180 / EIGEN_PI;
}

Result<FloorView> plannedView(const PlannedCamera &camera, const MarkerLayout &layout, double sigmaPx)
{
    if (!(camera.heightM >= 0.05 && camera.heightM <= 100))
        return noCamera("it cannot stand " + formatNumber(camera.heightM, 2) + " m above the floor", "give a height of 0.05 m to 100 m");
    if (!(camera.distanceM >= 0 && camera.distanceM <= 1000))
        return noCamera("it cannot stand " + formatNumber(camera.distanceM, 2) + " m away", "give a distance of 0 m to 1000 m");
    if (!(camera.fieldOfViewDegrees >= 2 && camera.fieldOfViewDegrees <= 150) || camera.widthPx <= 0 || camera.heightPx <= 0)
        return noCamera("its field of view is " + formatNumber(camera.fieldOfViewDegrees, 1) + "°", "give 2° to 150°, and the size of its pictures");
    const double direction = camera.directionDegrees * EIGEN_PI / 180;
    const Vector2d away(std::cos(direction), std::sin(direction));
    const Vector2d foot = camera.footM();
    const Vector3d place(foot.x(), foot.y(), camera.heightM);
    const Vector3d forward = (Vector3d(camera.aimM.x(), camera.aimM.y(), 0) - place).normalized();
    // Along the floor, so that the picture is upright; straight down it has no up, and the direction gives one.
    const Vector3d right(-away.y(), away.x(), 0);
    Eigen::Matrix3d axes;
    axes << right, forward.cross(right), forward;
    Intrinsics lens = CameraModel::assumed(camera.widthPx, camera.heightPx).intrinsics();
    lens.fxPx = lens.fyPx = 0.5 * camera.widthPx / std::tan(0.5 * camera.fieldOfViewDegrees * EIGEN_PI / 180);
    const auto model = CameraModel::create(std::move(lens));
    if (!model)
        return tl::unexpected(model.error());
    const FloorView exact(*model, {Eigen::Quaterniond(axes), place}, Eigen::Matrix<double, 6, 6>::Zero());
    const auto covariance = poseCovariance(exact, layout, sigmaPx);
    if (!covariance)
        return tl::unexpected(covariance.error());
    return FloorView(*model, exact.worldFromCamera(), *covariance);
}

} // namespace odo
