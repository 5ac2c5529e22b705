// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"
#include "core/calibration/internal/board_shape.h"
#include "core/geometry/camera_model.h"
#include "core/geometry/cross_matrix.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <ceres/cost_function.h>
#include <cmath>

namespace odo {

/// Number of values of a lens with all of its coefficients: fx, fy, cx, cy, distortion.
constexpr int intrinsicsSize(LensModel model)
{
    return model == LensModel::Rational ? 12 : model == LensModel::Fisheye ? 8 : 9;
}

/// The pixel of a point as a lens of this model sees it, with its derivatives: the formulas of CameraModel,
/// for lenses that are being sought, which may bend in ways that CameraModel refuses.
template <LensModel model>
struct LensProjection
{
    Eigen::Vector2d pixel;
    Eigen::Matrix<double, 2, 3> byPoint;
    Eigen::Matrix<double, 2, intrinsicsSize(model)> byIntrinsics;

    /// lens: as intrinsicsSize says; point in the camera's frame. False behind the camera. Without
    /// `derivatives` only the pixel is found.
    bool find(const double *lens, const Eigen::Vector3d &point, bool derivatives)
    {
        const bool seen = model == LensModel::Fisheye ? bendByAngle(lens + 4, point, derivatives)
                                                      : bendByRadius(lens + 4, point, derivatives);
        if (!seen)
            return false;
        pixel = {lens[0] * m_bent.x() + lens[2], lens[1] * m_bent.y() + lens[3]};
        if (derivatives) {
            byIntrinsics.template leftCols<4>() << m_bent.x(), 0, 1, 0, 0, m_bent.y(), 0, 1;
            for (int row = 0; row < 2; ++row) {
                byPoint.row(row) *= lens[row];
                byIntrinsics.row(row).template tail<intrinsicsSize(model) - 4>() *= lens[row];
            }
        }
        return true;
    }

private:
    /// Brown and Conrady's, with a divisor where the model is rational.
    bool bendByRadius(const double *k, const Eigen::Vector3d &point, bool derivatives)
    {
        if (!(point.z() > 1e-9))
            return false;
        const double inverse = 1 / point.z(), x = point.x() * inverse, y = point.y() * inverse,
                     u = x * x + y * y;
        const double above = 1 + u * (k[0] + u * (k[1] + u * k[4]));
        double below = 1, belowByU = 0;
        if constexpr (model == LensModel::Rational) {
            below = 1 + u * (k[5] + u * (k[6] + u * k[7]));
            belowByU = k[5] + u * (2 * k[6] + u * 3 * k[7]);
        }
        const double radial = above / below, p1 = k[2], p2 = k[3];
        m_bent = {x * radial + 2 * p1 * x * y + p2 * (u + 2 * x * x),
                  y * radial + p1 * (u + 2 * y * y) + 2 * p2 * x * y};
        if (!derivatives)
            return true;
        const double slope = (k[0] + u * (2 * k[1] + u * 3 * k[4]) - radial * belowByU) / below;
        const double xx = radial + 2 * x * x * slope + 2 * p1 * y + 6 * p2 * x,
                     xy = 2 * x * y * slope + 2 * p1 * x + 2 * p2 * y;
        const double yy = radial + 2 * y * y * slope + 6 * p1 * y + 2 * p2 * x;
        byPoint << xx * inverse, xy * inverse, -(xx * x + xy * y) * inverse, xy * inverse, yy * inverse,
            -(xy * x + yy * y) * inverse;
        const double u1 = u / below, u2 = u * u1, u3 = u * u2;
        byIntrinsics.template middleCols<5>(4) << x * u1, x * u2, 2 * x * y, u + 2 * x * x, x * u3, y * u1,
            y * u2, u + 2 * y * y, 2 * x * y, y * u3;
        if constexpr (model == LensModel::Rational)
            byIntrinsics.template rightCols<3>() << -radial * x * u1, -radial * x * u2, -radial * x * u3,
                -radial * y * u1, -radial * y * u2, -radial * y * u3;
        return true;
    }

    /// Kannala and Brandt's.
    bool bendByAngle(const double *k, const Eigen::Vector3d &point, bool derivatives)
    {
        const Eigen::Vector2d across = point.head<2>();
        const double radius = std::sqrt(across.squaredNorm() + 1e-24),
                     squared = radius * radius + point.z() * point.z();
        const double angle = std::atan2(radius, point.z()), u = angle * angle;
        const double bent = angle * (1 + u * (k[0] + u * (k[1] + u * (k[2] + u * k[3]))));
        const Eigen::Vector2d outward = across / radius;
        m_bent = bent * outward;
        if (!(squared > 0) || !derivatives)
            return squared > 0;
        const double slope = 1 + u * (3 * k[0] + u * (5 * k[1] + u * (7 * k[2] + u * 9 * k[3])));
        const double along = slope * point.z() / squared, aside = bent / radius;
        byPoint.template leftCols<2>() = (along - aside) * outward * outward.transpose();
        byPoint(0, 0) += aside;
        byPoint(1, 1) += aside;
        byPoint.col(2) = -slope * radius / squared * outward;
        double power = angle * u;
        for (int i = 0; i < 4; ++i, power *= u)
            byIntrinsics.col(4 + i) = power * outward;
        return true;
    }

    Eigen::Vector2d m_bent; ///< on the plane one focal length ahead
};

/// All corners of one view of a board against a lens, a pose (rotation vector and translation,
/// cameraFromBoard) and the print's shape (BoardShape::values): two residuals a corner, predicted minus seen.
/// One block a view, since a block a corner costs Ceres more than its contents.
template <LensModel model>
class ViewCost : public ceres::CostFunction
{
public:
    static constexpr int size = intrinsicsSize(model);
    template <int columns>
    using Derivatives = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, columns, Eigen::RowMajor>>;

    /// cauchyPx: not 0, then each corner's distance r counts as scale · sqrt(log(1 + (r / scale)²)), whose
    /// square is Cauchy's loss. view and print, of which the values do not matter: must outlive this.
    ViewCost(const BoardView &view, const BoardShape &print, double cauchyPx)
        : m_view(view), m_print(print), m_cauchyPx(cauchyPx)
    {
        set_num_residuals(static_cast<int>(2 * view.pixels.size()));
        *mutable_parameter_block_sizes() = {size, 6, BoardShape::size};
    }

    bool Evaluate(const double *const *parameters, double *residuals, double **derivatives) const override
    {
        const double *lens = parameters[0], *pose = parameters[1];
        const Eigen::Vector3d turn(pose[0], pose[1], pose[2]), position(pose[3], pose[4], pose[5]);
        const double angle = turn.norm();
        const Eigen::Matrix3d axes = angle > 0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                               : Eigen::Matrix3d::Identity();
        const bool wanted = derivatives != nullptr, shapeWanted = wanted && derivatives[2];
        const Eigen::Matrix3d byTurn = wanted ? leftJacobian(turn, angle) : Eigen::Matrix3d::Zero();
        LensProjection<model> seen;
        for (std::size_t i = 0; i < m_view.pixels.size(); ++i) {
            const Eigen::Vector3d arm = axes * m_print.at(m_view.pointsOnBoard[i], parameters[2]);
            if (!seen.find(lens, arm + position, wanted))
                return false;
            Eigen::Matrix<double, 2, 6> byPose;
            if (wanted) {
                for (int row = 0; row < 2; ++row)
                    byPose.row(row).head<3>() =
                        arm.cross(seen.byPoint.row(row).transpose()).transpose() * byTurn;
                byPose.template rightCols<3>() = seen.byPoint;
            }
            Eigen::Matrix<double, 2, BoardShape::size> byShape;
            if (shapeWanted)
                byShape = seen.byPoint * axes * m_print.derivative(m_view.pointsOnBoard[i]);
            Eigen::Vector2d off = seen.pixel - m_view.pixels[i];
            if (m_cauchyPx > 0) {
                const Eigen::Matrix2d change = heedLess(off);
                if (wanted) {
                    seen.byIntrinsics = change * seen.byIntrinsics;
                    byPose = change * byPose;
                }
                if (shapeWanted)
                    byShape = change * byShape;
            }
            const auto row = static_cast<Eigen::Index>(2 * i);
            Eigen::Map<Eigen::Vector2d>(residuals + row) = off;
            if (wanted && derivatives[0])
                Derivatives<size>(derivatives[0], num_residuals(), size).template middleRows<2>(row) =
                    seen.byIntrinsics;
            if (wanted && derivatives[1])
                Derivatives<6>(derivatives[1], num_residuals(), 6).template middleRows<2>(row) = byPose;
            if (shapeWanted)
                Derivatives<BoardShape::size>(derivatives[2], num_residuals(), BoardShape::size)
                    .template middleRows<2>(row) = byShape;
        }
        return true;
    }

private:
    /// How a rotation vector's change turns what it has turned already (Chirikjian 2012, 10.86).
    static Eigen::Matrix3d leftJacobian(const Eigen::Vector3d &turn, double angle)
    {
        const Eigen::Matrix3d cross = crossMatrix(turn);
        if (angle < 1e-5)
            return Eigen::Matrix3d::Identity() + 0.5 * cross;
        const double squared = angle * angle;
        return Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / squared * cross +
               (angle - std::sin(angle)) / (squared * angle) * cross * cross;
    }

    /// Draws the distance in as Cauchy's loss wants it; returns how its derivatives change.
    Eigen::Matrix2d heedLess(Eigen::Vector2d &off) const
    {
        const double scale = m_cauchyPx * m_cauchyPx, squared = off.squaredNorm(), part = squared / scale;
        if (!(part > 1e-9))
            return Eigen::Matrix2d::Identity();
        const double factor = std::sqrt(std::log1p(part) / part);
        // d(factor)/d(squared), from factor² = log(1 + part) / part.
        const double slope = (1 / (1 + part) - factor * factor) / (2 * factor * squared);
        const Eigen::Matrix2d change =
            factor * Eigen::Matrix2d::Identity() + 2 * slope * off * off.transpose();
        off *= factor;
        return change;
    }

    const BoardView &m_view;
    const BoardShape &m_print;
    double m_cauchyPx;
};

} // namespace odo
