// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/camera_model.h"

#include "core/base/units.h"
#include "core/geometry/internal/lens_curve.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

tl::unexpected<Error> unusable(Message why)
{
    return fail(ErrorCode::InvalidInput,
                ODO_TEXT("geometry.intrinsics_unusable", "these intrinsics cannot be used"), std::move(why),
                ODO_TEXT("geometry.calibrate_again", "calibrate the camera again, or import another file"));
}

bool isCountAllowed(LensModel model, std::size_t count)
{
    switch (model) {
    case LensModel::Standard:
        return count == 0 || count == 4 || count == 5;
    case LensModel::Rational:
        return count == 0 || count == 8;
    case LensModel::Fisheye:
        return count == 0 || count == 4;
    }
    return false;
}

bool isFinite(const Intrinsics &intrinsics)
{
    const auto finite = [](double value) { return std::isfinite(value); };
    return finite(intrinsics.fxPx) && finite(intrinsics.fyPx) && finite(intrinsics.cxPx) &&
           finite(intrinsics.cyPx) && std::ranges::all_of(intrinsics.distortion, finite) &&
           intrinsics.covariance.allFinite();
}

/// Brown–Conrady distortion of (x/z, y/z), with the derivative by it (OpenCV's formula, calib3d's
/// documentation).
Vector2d distort(const std::array<double, 8> &k, const Vector2d &ideal, Matrix2d &byIdeal)
{
    const double x = ideal.x(), y = ideal.y(), u = ideal.squaredNorm();
    const double above = 1 + u * (k[0] + u * (k[1] + u * k[4]));
    const double below = 1 + u * (k[5] + u * (k[6] + u * k[7]));
    const double aboveByU = k[0] + u * (2 * k[1] + u * 3 * k[4]);
    const double belowByU = k[5] + u * (2 * k[6] + u * 3 * k[7]);
    const double radial = above / below;
    const double radialByU = (aboveByU - radial * belowByU) / below;
    const double p1 = k[2], p2 = k[3];
    byIdeal << radial + 2 * x * x * radialByU + 2 * p1 * y + 6 * p2 * x,
        2 * x * y * radialByU + 2 * p1 * x + 2 * p2 * y, 2 * x * y * radialByU + 2 * p1 * x + 2 * p2 * y,
        radial + 2 * y * y * radialByU + 6 * p1 * y + 2 * p2 * x;
    return {x * radial + 2 * p1 * x * y + p2 * (u + 2 * x * x),
            y * radial + p1 * (u + 2 * y * y) + 2 * p2 * x * y};
}

/// distort() by k1 k2 p1 p2 k3 k4 k5 k6.
Eigen::Matrix<double, 2, 8> distortedByCoefficients(const std::array<double, 8> &k, const Vector2d &ideal)
{
    const double x = ideal.x(), y = ideal.y(), u = ideal.squaredNorm();
    const double below = 1 + u * (k[5] + u * (k[6] + u * k[7]));
    const double radial = (1 + u * (k[0] + u * (k[1] + u * k[4]))) / below;
    Eigen::Matrix<double, 2, 8> by;
    by.col(0) = ideal * (u / below);
    by.col(1) = u * by.col(0);
    by.col(2) = Vector2d(2 * x * y, u + 2 * y * y);
    by.col(3) = Vector2d(u + 2 * x * x, 2 * x * y);
    by.col(4) = u * by.col(1);
    by.rightCols<3>() = -radial * by(Eigen::all, {0, 1, 4});
    return by;
}

} // namespace

Result<CameraModel> CameraModel::create(Intrinsics intrinsics)
{
    if (intrinsics.widthPx <= 0 || intrinsics.heightPx <= 0)
        return unusable(ODO_TEXT("geometry.size_not_positive", "the image size %1 is not positive")(
            std::to_string(intrinsics.widthPx) + "x" + std::to_string(intrinsics.heightPx)));
    if (!isFinite(intrinsics))
        return unusable(ODO_TEXT("geometry.value_not_finite", "one of the values is not a finite number"));
    if (intrinsics.fxPx <= 0 || intrinsics.fyPx <= 0)
        return unusable(ODO_TEXT("geometry.focal_not_positive", "the focal length %1 is not positive")(
            quantity(std::min(intrinsics.fxPx, intrinsics.fyPx), 3, "px")));
    const std::size_t count = intrinsics.distortion.size();
    if (!isCountAllowed(intrinsics.model, count))
        return unusable(ODO_TEXT("geometry.wrong_coefficients",
                                 "this lens model does not take %1 distortion coefficients")(count));
    const auto parameters = static_cast<Eigen::Index>(4 + count);
    if (intrinsics.covariance.size() != 0 &&
        (intrinsics.covariance.rows() != parameters || intrinsics.covariance.cols() != parameters))
        return unusable(ODO_TEXT("geometry.wrong_covariance_size", "the covariance has the wrong size"));
    return CameraModel(std::move(intrinsics));
}

CameraModel CameraModel::assumed(int widthPx, int heightPx)
{
    Intrinsics intrinsics;
    intrinsics.widthPx = std::max(widthPx, 1);
    intrinsics.heightPx = std::max(heightPx, 1);
    intrinsics.fxPx = intrinsics.fyPx = 1.2 * std::max(intrinsics.widthPx, intrinsics.heightPx);
    intrinsics.cxPx = 0.5 * (intrinsics.widthPx - 1);
    intrinsics.cyPx = 0.5 * (intrinsics.heightPx - 1);
    return CameraModel(std::move(intrinsics));
}

CameraModel::CameraModel(Intrinsics intrinsics) : m_intrinsics(std::move(intrinsics))
{
    std::ranges::copy(m_intrinsics.distortion, m_coefficients.begin());
    m_limit = LensCurve(m_coefficients, m_intrinsics.model == LensModel::Fisheye).limit();
}

std::optional<Vector2d> CameraModel::project(const Vector3d &pointInCamera) const
{
    Eigen::Matrix<double, 2, 3> unused;
    return project(pointInCamera, unused);
}

std::optional<Vector2d> CameraModel::project(const Vector3d &pointInCamera,
                                             Eigen::Matrix<double, 2, 3> &pixelByPoint) const
{
    if (m_intrinsics.model == LensModel::Fisheye)
        return projectFisheye(pointInCamera, pixelByPoint);
    const double z = pointInCamera.z();
    if (!(z > 0))
        return std::nullopt;
    const Vector2d ideal = pointInCamera.head<2>() / z;
    if (!ideal.allFinite() || ideal.norm() > m_limit)
        return std::nullopt;
    Matrix2d byIdeal;
    const Vector2d distorted = distort(m_coefficients, ideal, byIdeal);
    if (!(byIdeal.determinant() > 0)) // tangential distortion has turned the image over
        return std::nullopt;
    Eigen::Matrix<double, 2, 3> idealByPoint;
    idealByPoint << 1 / z, 0, -ideal.x() / z, 0, 1 / z, -ideal.y() / z;
    const Vector2d focal(m_intrinsics.fxPx, m_intrinsics.fyPx);
    pixelByPoint = focal.asDiagonal() * byIdeal * idealByPoint;
    return Vector2d(focal.cwiseProduct(distorted) + Vector2d(m_intrinsics.cxPx, m_intrinsics.cyPx));
}

std::optional<Vector2d> CameraModel::projectFisheye(const Vector3d &point,
                                                    Eigen::Matrix<double, 2, 3> &pixelByPoint) const
{
    const Vector2d focal(m_intrinsics.fxPx, m_intrinsics.fyPx);
    const Vector2d centre(m_intrinsics.cxPx, m_intrinsics.cyPx);
    const Vector2d across = point.head<2>();
    const double radius = across.norm(), squared = point.squaredNorm();
    const double angle = std::atan2(radius, point.z());
    if (!(squared > 0) || !std::isfinite(squared) || angle > m_limit)
        return std::nullopt;
    if (radius < 1e-9 * std::abs(point.z())) { // on the axis, where the formula below divides 0 by 0
        if (point.z() < 0)
            return std::nullopt;
        pixelByPoint << 1 / point.z(), 0, 0, 0, 1 / point.z(), 0;
        pixelByPoint = focal.asDiagonal() * pixelByPoint;
        return Vector2d(centre + focal.cwiseProduct(across) / point.z());
    }
    const LensCurve curve(m_coefficients, true);
    const double bent = curve.value(angle), slope = curve.slope(angle);
    const Vector2d outward = across / radius;
    const Eigen::RowVector2d angleByAcross = (point.z() / squared) * outward.transpose();
    pixelByPoint.leftCols<2>() = slope * outward * angleByAcross +
                                 bent / radius * (Matrix2d::Identity() - outward * outward.transpose());
    pixelByPoint.col(2) = -slope * radius / squared * outward;
    pixelByPoint = focal.asDiagonal() * pixelByPoint;
    return Vector2d(centre + focal.cwiseProduct(bent * outward));
}

PixelByIntrinsics CameraModel::pixelByIntrinsics(const Vector3d &pointInCamera) const
{
    const auto coefficients = static_cast<Eigen::Index>(m_intrinsics.distortion.size());
    const Vector2d focal(m_intrinsics.fxPx, m_intrinsics.fyPx);
    Vector2d bent = Vector2d::Zero();
    Eigen::Matrix<double, 2, 8> byCoefficients = Eigen::Matrix<double, 2, 8>::Zero();
    if (m_intrinsics.model == LensModel::Fisheye) {
        const double radius = pointInCamera.head<2>().norm();
        if (radius > 0) {
            const Vector2d outward = pointInCamera.head<2>() / radius;
            const double angle = std::atan2(radius, pointInCamera.z());
            bent = LensCurve(m_coefficients, true).value(angle) * outward;
            for (int i = 0; i < 4; ++i)
                byCoefficients.col(i) = std::pow(angle, 3 + 2 * i) * outward;
        }
    } else {
        const Vector2d ideal = pointInCamera.hnormalized();
        Matrix2d unused;
        bent = distort(m_coefficients, ideal, unused);
        byCoefficients = distortedByCoefficients(m_coefficients, ideal);
    }
    PixelByIntrinsics by(2, 4 + coefficients);
    by.leftCols<4>() << bent.x(), 0, 1, 0, 0, bent.y(), 0, 1;
    by.rightCols(coefficients) = focal.asDiagonal() * byCoefficients.leftCols(coefficients);
    return by;
}

std::optional<Vector3d> CameraModel::unproject(const Vector2d &pixel) const
{
    const Vector2d wanted((pixel.x() - m_intrinsics.cxPx) / m_intrinsics.fxPx,
                          (pixel.y() - m_intrinsics.cyPx) / m_intrinsics.fyPx);
    if (!wanted.allFinite())
        return std::nullopt;
    if (m_intrinsics.model == LensModel::Fisheye)
        return unprojectFisheye(wanted);
    if (std::isinf(m_limit)) // no distortion
        return wanted.homogeneous();
    // The radial part alone gives a start inside the usable region; from there Newton adds the tangential
    // part.
    const double radius = wanted.norm();
    const double start = LensCurve(m_coefficients, false).inverse(radius, m_limit).value_or(m_limit);
    Vector2d ideal = radius > 0 ? Vector2d(wanted * (start / radius)) : Vector2d::Zero();
    for (int i = 0; i < 30; ++i) {
        Matrix2d byIdeal;
        const Vector2d error = distort(m_coefficients, ideal, byIdeal) - wanted;
        if (!(byIdeal.determinant() > 0) || !(ideal.norm() <= m_limit * (1 + 1e-9)))
            return std::nullopt;
        const Vector2d step = byIdeal.inverse() * error;
        if (error.norm() < 1e-12 && step.norm() < 1e-12)
            return ideal.homogeneous();
        ideal -= step;
    }
    return std::nullopt;
}

std::optional<Vector3d> CameraModel::unprojectFisheye(const Vector2d &distorted) const
{
    const double bent = distorted.norm();
    if (bent == 0)
        return Vector3d(0, 0, 1);
    const auto angle = LensCurve(m_coefficients, true).inverse(bent, m_limit);
    if (!angle)
        return std::nullopt;
    const Vector2d across = distorted * (std::sin(*angle) / bent);
    const Vector3d ray(across.x(), across.y(), std::cos(*angle));
    return ray.z() > 1e-6 ? Vector3d(ray / ray.z()) : ray;
}

} // namespace odo
