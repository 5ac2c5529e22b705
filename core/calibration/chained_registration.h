// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_registration.h"

#include <string>
#include <vector>

namespace odo {

/// A point of the floor that two cameras see, in luma pixels of each.
struct SharedPoint
{
    std::string label;
    Eigen::Vector2d pixel;          ///< in the camera that is to be registered
    Eigen::Vector2d referencePixel; ///< in the one that is registered already
};

/// A camera's registration through another camera.
struct ChainedRegistration
{
    FloorRegistration registration; ///< its verdict says how much of the error is the other camera's
    MarkerLayout positions;         ///< floor positions by the other camera; the name stays empty
    std::vector<MarkerPixel> pixels;
};

/// Registers a camera to the floor without markers: a registered camera (itself perhaps via another) projects
/// the points onto the floor, and the pose is fitted to these positions.
///
/// Each point has the covariance of both pixels (0.3 px each, or more where the points fit worse) and counts
/// by its information. The other camera's pose is common to all points and moves them together: its
/// covariance goes through the fit (central differences along the columns of its root) into the pose
/// covariance of this one, so that over a chain of cameras nothing is lost. The other camera's intrinsics
/// count as exact.
///
/// referenceName: the other camera for messages, as cameraSubject() has it. Refuses by name what
/// registerFloor refuses, and pixels outside the image, points at or beyond the other camera's horizon, and
/// points that are mirrored between the two images.
Result<ChainedRegistration> registerViaCamera(const FloorView &reference, const Message &referenceName,
                                              const std::vector<SharedPoint> &points,
                                              const CameraModel &camera, bool intrinsicsKnown);

} // namespace odo
