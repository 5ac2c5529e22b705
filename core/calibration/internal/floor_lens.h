// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/plane_pose.h"

namespace odo {

/// A lens that nobody calibrated, estimated with its camera's pose from markers on the floor.
struct FloorLens
{
    /// The pose with its lens: camera carries the covariance of what the markers leave open of the lens
    /// (fx, fy, cx, cy, distortion...), inverseNormal the pose's with that lens held. sigmaPx is of one
    /// coordinate of a marker (markSigmaPx).
    PlanePose pose;
    /// RMS distance of each marker from where the fit without it puts it (to first order; Allen's PRESS,
    /// 1974).
    double heldOutPx = 0;
    double studentFactor = 1; ///< in sigmaPx (markStudentFactor)
};

/// Maximum a posteriori of pose and lens. What is known of a lens before any marker is seen is its prior:
/// how the lenses of webcams, phones and action cameras differ (the constants of the source file). Markers
/// outweigh it as far as they determine the lens; where they do not, the prior stays, and so does its σ: of
/// few markers the lens is as unsure as lenses are, and the floor away from them with it. Gauss–Newton with
/// Levenberg's damping over both, in turn with the σ of a marker's pixel until that stays (Gaussian
/// linearisation; Bishop 2006, 3.3 and 4.4).
///
/// pairs: floor position, metres, and pixel. start: a pose that is nearly right, with the camera it was
/// fitted with. nullopt where no such pose and lens exist. Pure; any thread.
std::optional<FloorLens> fitFloorLens(std::span<const PointPair> pairs, const PlanePose &start);

} // namespace odo
