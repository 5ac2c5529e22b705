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

    Eigen::Vector3d operator*(const Eigen::Vector3d &pointInSource) const
    {
        return rotation * pointInSource + translation;
    }
    RigidTransform operator*(const RigidTransform &other) const
    {
        return {(rotation * other.rotation).normalized(), rotation * other.translation + translation};
    }
    RigidTransform inverse() const
    {
        const Eigen::Quaterniond back = rotation.conjugate();
        return {back, -(back * translation)};
    }
};

} // namespace odo
