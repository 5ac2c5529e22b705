// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/synchronisation/internal/track_sampling.h"

#include <Eigen/Core>
#include <vector>

namespace odo {

/// Offset and rate of the second view's clock against the first view's: what the second view stamps u was
/// taken at offset + u / (1 + rate) of the first view's clock (core/trajectory/analyser.h), by the stamps of
/// both as they are after their repair.
struct ClipOffset
{
    double offsetS = 0; ///< how much later the second view's first frame was taken than the first view's
    double sigmaS = 0;
    double score = 0;     ///< 0 to 1: part of the motion's variance that both views share at this offset
    double rate = 0;      ///< by how much the second clock runs faster; 0 where it is not significant
    double rateSigma = 0; ///< also if the rate is 0: how well the motion determines it
    ClockRepair first = {}, second = {}; ///< of each view's stamps; none where they are even
};

/// A clock that is wrong by more is one whose clip states another frame rate than it was recorded at.
inline constexpr double largestClockRate = 0.0225;

/// "synchronisation of the clips", as the subject of errors.
Message clipsSubject();

/// Why no offset is found, with the advice common to all searches.
tl::unexpected<Error> undeterminedOffset(Message why);

/// The offsets to look at.
struct OffsetRange
{
    double middleS = 0, halfWidthS = 10;
};

/// Finds the offset, and the rate difference, at which the floor tracks of one robot in two views coincide:
/// least squares of r(t) = p1(t) − p2((t − offset)(1 + rate)). A constant shift and a small scale between the
/// tracks are fitted as well, for a plane at a wrong height moves a view's track by just these (away from the
/// camera's foot, in proportion); so a straight run at constant speed determines nothing, and is refused.
/// Of cameras with more than 120 frames a second the means of neighbouring positions count as frames.
/// Searches the range in half frames, refines by Gauss–Newton. σ from the curvature, less what noise
/// adds to it, and the residual, taking the residuals as correlated over half a second. The rate is taken
/// where it is beyond 3σ, makes the tracks agree better, and is one that a clock can have (two percent).
///
/// Where one offset and rate do not explain the tracks, frames that one view lost or doubled, pauses, jumps
/// of a clock, rates up to ±2 % and those of wrong labels (half to twice the frame rate) are searched
/// together. If another relation explains the tracks nearly as well, σ covers it; from a σ of three frames
/// on the offset is refused. σ also holds what a rate that is not significant would do at the ends. Pure; any
/// thread. Undetermined, with the cause that was found by a test of it: too few or too short common
/// positions, no or uniform motion, periodic motion with two equal answers, relations that explain the tracks
/// alike, tracks of different form, nothing in common.
Result<ClipOffset> estimateClipOffset(const std::vector<TimedPosition> &firstTrack,
                                      const std::vector<TimedPosition> &secondTrack,
                                      const OffsetRange &range);

} // namespace odo
