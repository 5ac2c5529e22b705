// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rigid_transform.h"

namespace odo {

Eigen::Vector3d RigidTransform::operator*(const Eigen::Vector3d &pointInSource) const
{
    return rotation * pointInSource + translation;
}

RigidTransform RigidTransform::operator*(const RigidTransform &other) const
{
    return {(rotation * other.rotation).normalized(), rotation * other.translation + translation};
}

RigidTransform RigidTransform::inverse() const
{
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, -(back * translation)};
}

} // namespace odo
