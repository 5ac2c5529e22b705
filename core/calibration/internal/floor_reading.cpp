// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_reading.h"

#include "core/calibration/internal/lens_spread.h"
#include "core/calibration/intrinsics_influence.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr std::size_t leastCoefficients = 4; // of a standard lens, k1 among them

/// What the markers' pixels leave of a covariance of the lens, their pose free.
MatrixXd conditioned(const MatrixXd &before, const MarkerDerivatives &markers, double sigmaPx)
{
    const Eigen::ColPivHouseholderQR<MatrixXd> pose(markers.byPose);
    const MatrixXd unexplained = markers.byIntrinsics - markers.byPose * pose.solve(markers.byIntrinsics);
    // Σ − ΣUᵀ(UΣUᵀ + s²)⁻¹UΣ, since Σ has no inverse where a coefficient stays.
    const MatrixXd carried = unexplained * before;
    MatrixXd seen = carried * unexplained.transpose();
    seen.diagonal().array() += sigmaPx * sigmaPx;
    return before - carried.transpose() * seen.ldlt().solve(carried);
}

/// The lens that was assumed with what is not known of it; the camera itself where it says that already (a
/// lens estimated from the floor), or where that cannot be said.
CameraModel withSpread(const FloorRegistration &registration, const CameraModel &camera,
                       const std::vector<MarkerPixel> &pixels, double sigmaPx)
{
    Intrinsics lens = camera.intrinsics();
    const bool isSpread = lens.covariance.rows() > 4 && !lens.distortion.empty();
    if (lens.model != LensModel::Standard || isSpread)
        return camera;
    lens.distortion.resize(std::max(leastCoefficients, lens.distortion.size()), 0.0);
    lens.covariance = covarianceOf(lens, assumedLensSpread);
    const auto bent = CameraModel::create(lens);
    const auto derivatives = bent ? markerDerivatives(*bent, registration.worldFromCamera,
                                                      markersOnFloorOf(registration, camera, pixels))
                                  : std::nullopt;
    if (!derivatives || derivatives->byPose.rows() < 8)
        return camera;
    lens.covariance = conditioned(lens.covariance, *derivatives, sigmaPx);
    return CameraModel::create(std::move(lens)).value_or(camera);
}

} // namespace

double readSigmaPx(const FloorRegistration &registration)
{
    const auto markers = double(registration.markers.size());
    const double squares = registration.rmsPx * registration.rmsPx * markers;
    return std::max(usualMarkSigmaPx, markSigmaPx(squares, 2 * markers - 6));
}

FloorReading::FloorReading(const FloorRegistration &registration, const CameraModel &camera,
                           const std::vector<MarkerPixel> &pixels, bool areIntrinsicsAssumed)
    : m_pixelSigmaPx(readSigmaPx(registration)),
      m_view(floorViewOf(
          registration,
          areIntrinsicsAssumed ? withSpread(registration, camera, pixels, m_pixelSigmaPx) : camera, pixels))
{
}

std::optional<ReadPosition> FloorReading::at(const Vector2d &pixel, double heightM) const
{
    const auto position =
        m_view.locate(pixel, m_pixelSigmaPx * m_pixelSigmaPx * Matrix2d::Identity(), heightM);
    if (!position)
        return std::nullopt;
    const ReadPosition read{position->pointInWorld,
                            position->pixelCovariance + position->calibrationCovariance};
    if (!read.pointInWorld.allFinite() || !read.covariance.allFinite())
        return std::nullopt;
    return read;
}

std::vector<LocatedPoint> FloorReading::located(const std::vector<MarkerPixel> &points, double heightM) const
{
    std::vector<LocatedPoint> located;
    for (const MarkerPixel &point : points)
        located.push_back({point.label, point.pixel, at(point.pixel, heightM)});
    return located;
}

} // namespace odo
