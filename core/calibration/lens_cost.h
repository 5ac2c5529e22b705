// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"
#include "core/calibration/lens_projection.h"

#include <Eigen/Geometry>
#include <ceres/cost_function.h>

namespace odo {

/// All corners of one view of a board against a lens and a pose (rotation vector and translation,
/// cameraFromBoard): two residuals a corner, foretold minus seen. One block a view, since a block a corner
/// costs Ceres more than its contents.
template <LensModel model>
class ViewCost : public ceres::CostFunction
{
public:
    static constexpr int size = lensSize(model);
    template <int columns>
    using Derivatives = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, columns, Eigen::RowMajor>>;

    /// cauchyPx: not 0, then each corner's distance r counts as scale · sqrt(log(1 + (r / scale)²)), whose
    /// square is Cauchy's loss. view: must outlive this.
    ViewCost(const BoardView &view, double cauchyPx) : m_view(view), m_cauchyPx(cauchyPx)
    {
        set_num_residuals(static_cast<int>(2 * view.pixels.size()));
        *mutable_parameter_block_sizes() = {size, 6};
    }

    bool Evaluate(const double *const *parameters, double *residuals, double **derivatives) const override
    {
        const double *lens = parameters[0], *pose = parameters[1];
        const Eigen::Vector3d turn(pose[0], pose[1], pose[2]), place(pose[3], pose[4], pose[5]);
        const double angle = turn.norm();
        const Eigen::Matrix3d axes = angle > 0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                               : Eigen::Matrix3d::Identity();
        const bool wanted = derivatives != nullptr;
        const Eigen::Matrix3d byTurn = wanted ? leftJacobian(turn, angle) : Eigen::Matrix3d::Zero();
        LensProjection<model> seen;
        for (std::size_t i = 0; i < m_view.pixels.size(); ++i) {
            const Eigen::Vector3d arm = axes.leftCols<2>() * m_view.pointsOnBoard[i];
            if (!seen.find(lens, arm + place, wanted))
                return false;
            Eigen::Matrix<double, 2, 6> byPose;
            if (wanted) {
                for (int row = 0; row < 2; ++row)
                    byPose.row(row).head<3>() =
                        arm.cross(seen.byPoint.row(row).transpose()).transpose() * byTurn;
                byPose.template rightCols<3>() = seen.byPoint;
            }
            Eigen::Vector2d off = seen.pixel - m_view.pixels[i];
            if (m_cauchyPx > 0)
                heedLess(off, wanted ? &seen.byLens : nullptr, byPose);
            const auto row = static_cast<Eigen::Index>(2 * i);
            Eigen::Map<Eigen::Vector2d>(residuals + row) = off;
            if (wanted && derivatives[0])
                Derivatives<size>(derivatives[0], num_residuals(), size).template middleRows<2>(row) =
                    seen.byLens;
            if (wanted && derivatives[1])
                Derivatives<6>(derivatives[1], num_residuals(), 6).template middleRows<2>(row) = byPose;
        }
        return true;
    }

private:
    /// How a rotation vector's change turns what it has turned already (Chirikjian 2012, 10.86).
    static Eigen::Matrix3d leftJacobian(const Eigen::Vector3d &turn, double angle)
    {
        Eigen::Matrix3d cross;
        cross << 0, -turn.z(), turn.y(), turn.z(), 0, -turn.x(), -turn.y(), turn.x(), 0;
        if (angle < 1e-5)
            return Eigen::Matrix3d::Identity() + 0.5 * cross;
        const double squared = angle * angle;
        return Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / squared * cross +
               (angle - std::sin(angle)) / (squared * angle) * cross * cross;
    }

    /// The distance drawn in as Cauchy's loss wants it, and its derivatives.
    void heedLess(Eigen::Vector2d &off, Eigen::Matrix<double, 2, size> *byLens,
                  Eigen::Matrix<double, 2, 6> &byPose) const
    {
        const double scale = m_cauchyPx * m_cauchyPx, squared = off.squaredNorm(), part = squared / scale;
        const double factor = part > 1e-9 ? std::sqrt(std::log1p(part) / part) : 1;
        if (byLens != nullptr) {
            // d(factor)/d(squared), from factor² = log(1 + part) / part.
            const double slope =
                part > 1e-9 ? (1 / (1 + part) - factor * factor) / (2 * factor * squared) : 0;
            const Eigen::Matrix2d change =
                factor * Eigen::Matrix2d::Identity() + 2 * slope * off * off.transpose();
            *byLens = change * *byLens;
            byPose = change * byPose;
        }
        off *= factor;
    }

    const BoardView &m_view;
    double m_cauchyPx;
};

} // namespace odo
