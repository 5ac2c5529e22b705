// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"

#include <Eigen/Core>
#include <vector>

namespace odo {

/// A place on the floor at a time of the view's own clock, zero at its first frame.
struct TimedPosition
{
    double timeS = 0;
    Eigen::Vector2d pointInWorld;
};

/// How much later the second view's first frame was taken than the first view's.
struct ClipOffset
{
    double offsetS = 0;
    double sigmaS = 0;
    double score = 0; ///< 0 to 1: part of the motion's variance that both views share at this offset
};

/// Finds the offset at which the floor tracks of one robot in two views coincide. A constant shift between the tracks
/// (height, calibration) is allowed for; so a straight run at constant speed determines nothing, and is refused.
/// Searches ±longestOffsetS in half frames, refines by Gauss–Newton; σ from the curvature and the residual, taking the
/// residuals as correlated over half a second. Pure; any thread.
/// Undetermined: too few common positions, no or uniform motion, periodic motion with two equal answers.
Result<ClipOffset> estimateClipOffset(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                                      double longestOffsetS);

} // namespace odo
