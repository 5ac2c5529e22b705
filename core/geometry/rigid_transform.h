// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

namespace odo {

/// A rotation followed by a translation, named targetFromSource: pointInTarget = targetFromSource *
/// pointInSource. Metres. A plain value.
struct RigidTransform
{
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Eigen::Vector3d operator*(const Eigen::Vector3d &pointInSource) const;
    RigidTransform operator*(const RigidTransform &other) const;
    RigidTransform inverse() const;
};

} // namespace odo
