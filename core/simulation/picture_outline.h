// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"
#include "core/geometry/rigid_transform.h"
#include "core/simulation/rgb_picture.h"

#include <span>
#include <vector>

namespace odo {

/// Turns flat polygons in space into their outlines in the picture: cut to what the camera can see, and with
/// the edges divided finely enough that the lens's bending is followed to a thousandth of a pixel. Immutable.
class PictureOutline
{
public:
    PictureOutline(CameraModel camera, RigidTransform cameraFromSource);

    /// Outline in luma pixels of a convex polygon (points in the source frame, metres); empty where it is out
    /// of sight.
    std::vector<Eigen::Vector2d> of(std::span<const Eigen::Vector3d> polygon) const;

    PixelRect pictureRect() const;

private:
    std::vector<Eigen::Vector3d> clipped(std::vector<Eigen::Vector3d> polygon) const;

    CameraModel m_camera;
    RigidTransform m_cameraFromSource;
    std::vector<Eigen::Vector3d> m_inward; ///< of the planes through the camera that bound what it sees
};

/// The smallest rectangle of whole pixels that an outline touches.
PixelRect boundsOf(std::span<const Eigen::Vector2d> outline);

} // namespace odo
