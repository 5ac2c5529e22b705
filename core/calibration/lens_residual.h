// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"

#include <Eigen/Core>
#include <ceres/jet.h>
#include <ceres/rotation.h>

namespace odo {

/// Number of values of a lens with all of its coefficients: fx, fy, cx, cy, distortion.
constexpr int lensSize(LensModel model)
{
    return model == LensModel::Rational ? 12 : model == LensModel::Fisheye ? 8 : 9;
}

/// Distance in pixels between a board's corner as seen and as a lens and a pose foretell it; the formulas of
/// CameraModel written for automatic derivatives. lens: as lensSize says; pose: rotation vector and
/// translation, cameraFromBoard.
template <LensModel model>
struct LensResidual
{
    Eigen::Vector2d pointOnBoard, pixel;

    template <class T>
    bool operator()(const T *lens, const T *pose, T *residual) const
    {
        const T onBoard[3] = {T(pointOnBoard.x()), T(pointOnBoard.y()), T(0)};
        T point[3];
        ceres::AngleAxisRotatePoint(pose, onBoard, point);
        for (int i = 0; i < 3; ++i)
            point[i] += pose[3 + i];
        T bent[2];
        if (!bend(lens + 4, point, bent))
            return false;
        residual[0] = lens[0] * bent[0] + lens[2] - pixel.x();
        residual[1] = lens[1] * bent[1] + lens[3] - pixel.y();
        return true;
    }

    template <class T>
    static bool bend(const T *k, const T *point, T *bent)
    {
        if constexpr (model == LensModel::Fisheye) {
            const T radius = sqrt(point[0] * point[0] + point[1] * point[1] + T(1e-24));
            const T angle = atan2(radius, point[2]), u = angle * angle;
            const T scale = angle * (1.0 + u * (k[0] + u * (k[1] + u * (k[2] + u * k[3])))) / radius;
            bent[0] = scale * point[0];
            bent[1] = scale * point[1];
            return true;
        } else {
            if (!(point[2] > T(1e-9)))
                return false;
            const T x = point[0] / point[2], y = point[1] / point[2], u = x * x + y * y;
            T radial = 1.0 + u * (k[0] + u * (k[1] + u * k[4]));
            if constexpr (model == LensModel::Rational)
                radial /= 1.0 + u * (k[5] + u * (k[6] + u * k[7]));
            bent[0] = x * radial + 2.0 * k[2] * x * y + k[3] * (u + 2.0 * x * x);
            bent[1] = y * radial + k[2] * (u + 2.0 * y * y) + 2.0 * k[3] * x * y;
            return true;
        }
    }
};

} // namespace odo
