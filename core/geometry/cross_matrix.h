// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace odo {

/// The matrix that multiplies a vector as v × does.
inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d &v)
{
    Eigen::Matrix3d matrix;
    matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return matrix;
}

} // namespace odo
