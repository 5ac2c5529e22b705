// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"

#include <optional>
#include <span>
#include <vector>

namespace odo {

struct FloorRegistration;

/// Derivatives of markers' pixels, two rows a marker: by the pose, as FloorView's poseCovariance has it, and
/// by the lens, a column each of (fx, fy, cx, cy, distortion...).
struct MarkerDerivatives
{
    Eigen::MatrixXd byPose, byIntrinsics;
};

/// Markers in metres on the floor. nullopt where one has no pixel.
std::optional<MarkerDerivatives> markerDerivatives(const CameraModel &camera,
                                                   const RigidTransform &worldFromCamera,
                                                   std::span<const Eigen::Vector2d> markersOnFloor);

/// How a pose fitted to markers follows the lens: −(JᵀJ)⁻¹Jᵀ·J_l, with J and J_l the derivatives of the
/// markers' pixels by pose and lens at the pose given (Gauss–Newton; the residuals' curvature is left out).
/// Markers in metres on the floor. 6×0 where a marker has no pixel or the markers determine no pose.
PoseByIntrinsics poseByIntrinsics(const CameraModel &camera, const RigidTransform &worldFromCamera,
                                  std::span<const Eigen::Vector2d> markersOnFloor);

/// Where a registration's markers are on the floor by their pixels through it; of the pixels those count that
/// the registration names.
std::vector<Eigen::Vector2d> markersOnFloorOf(const FloorRegistration &registration,
                                              const CameraModel &camera,
                                              const std::vector<MarkerPixel> &pixels);

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

/// Floor uncertainty of a typical testbed from the intrinsics alone. Metres; expectedOnFloor gives σ along
/// the least certain direction.
struct FloorExpectation
{
    double middleM = 0; ///< in the middle of the floor
    double worstM = 0;  ///< where it is largest
    Message worstWhere; ///< "in the far left corner", "at the near edge", as the camera sees it
};

/// The testbed that calibrations are judged by, since millimetres say more to a person than pixels: a camera
/// 2 m high, looking at a floor of 3 m × 2 m whose longer side lies along the image's longer side, from as
/// near as the whole floor is in the image (0.3 m from the near edge or more), and registered by four markers
/// at the floor's corners. The markers count as exact: what they add is the registration's part. nullopt
/// where no such position exists (a lens so long that the camera would be 60 m away).
std::optional<FloorView> typicalTestbed(const CameraModel &camera);

/// The testbed in the words of a verdict: "a 3 m × 2 m floor seen from 2 m above".
Message typicalTestbedWords();

/// The covariance of the intrinsics carried to the floor (poseByIntrinsics, FloorView), on a grid of 13 × 9
/// positions. nullopt where the lens has no covariance or no testbed fits it.
std::optional<FloorExpectation> expectedOnFloor(const Intrinsics &intrinsics);

/// How far two lenses of one camera put the same pixels apart on that floor, each registered by the same four
/// pixels.
std::optional<FloorExpectation> apartOnFloor(const Intrinsics &one, const Intrinsics &other);

} // namespace odo
