// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/accuracy_map.h"
#include "core/geometry/floor_view.h"

namespace odo {

/// Whether a pixel is within the image of a camera.
bool isWithin(const Eigen::Vector2d &pixel, const Intrinsics &lens);

/// The pose of an upright camera that looks at a point of the floor. Metres. across: along the floor, to the
/// camera's right: what is "right" of one that looks straight down.
RigidTransform lookingAt(const Eigen::Vector3d &position, const Eigen::Vector2d &aimM,
                         const Eigen::Vector2d &across);

/// A view with the uncertainty that it would have if it were registered by the markers it sees: σ²(JᵀJ)⁻¹ of
/// its pose, which follows its lens (core/calibration/intrinsics_influence.h) where that has a covariance.
/// sigmaPx: of one coordinate of a marker's pixel. InvalidInput where it sees fewer than four, naming them,
/// or where they do not determine its pose.
Result<FloorView> registeredByMarkers(const FloorView &exact, const MarkerLayout &layout, double sigmaPx);

/// σ of all views together over a grid of the floor.
struct FloorScore
{
    int unseen = 0; ///< positions
    double worstM = 0;
    std::vector<double> sigmaM; ///< as AccuracyMap::fusedSigmaM
};

/// anywhereM: σ of what is alike everywhere. The rest as accuracyMap takes it.
FloorScore floorScore(std::span<const FloorView> views, const FloorGrid &grid, double sigmaPx, double heightM,
                      double anywhereM = 0);

/// What is said of a camera that cannot be where it is planned.
tl::unexpected<Error> noPlannedCamera(Message why, Message advice);

} // namespace odo
