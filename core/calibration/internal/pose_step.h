// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/floor_view.h"

namespace odo {

/// A pose moved by a step of a fit, of (rotation vector of a left-applied turn, in radians; translation, in
/// metres), as FloorView's pose covariance has them. Any thread.
inline RigidTransform stepped(const RigidTransform &pose, const Eigen::Matrix<double, 6, 1> &step)
{
    RigidTransform moved = pose;
    const Eigen::Vector3d turn = step.head<3>();
    if (turn.norm() > 0)
        moved.rotation =
            (Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * pose.rotation)
                .normalized();
    moved.translation += step.tail<3>();
    return moved;
}

} // namespace odo
