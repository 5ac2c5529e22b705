// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"

#include <span>

namespace odo {

struct FloorRegistration;

/// How a pose fitted to markers follows the lens: −(JᵀJ)⁻¹Jᵀ·J_l, with J and J_l the derivatives of the
/// markers' pixels by pose and lens at the pose given (Gauss–Newton; the residuals' curvature is left out).
/// Markers in metres on the floor. 6×0 where a marker has no pixel or the markers determine no pose.
PoseByLens poseByLens(const CameraModel &camera, const RigidTransform &worldFromCamera,
                      std::span<const Eigen::Vector2d> markersOnFloor);

/// A registration as a view with its whole uncertainty, that of the lens included. camera: the lens it was
/// made with. pixels: those it was made from; of them the ones count that the registration names. Where a
/// marker lies is taken from its pixel through the registration, so that a layout changed since does no harm.
FloorView floorViewOf(const FloorRegistration &registration, const CameraModel &camera,
                      const std::vector<MarkerPixel> &pixels);

/// σ along the direction in which the calibration leaves a position the least sure. Metres.
double largestSigmaM(const FloorPosition &position);

/// The largest of these at the registration's markers, as FloorRegistration::floorSigmaM says.
double floorSigmaM(const FloorRegistration &registration, const CameraModel &camera,
                   const std::vector<MarkerPixel> &pixels);

} // namespace odo
