// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/fused_track.h"
#include "core/trajectory/kalman_smoother.h"

#include <span>
#include <vector>

namespace odo {

/// Measured nodes that a Kalman filter refuses (innovation beyond χ²(2) 99.9 %) both when it comes from the
/// past and when it comes from the future. A spike is refused from both sides; a real start, stop or
/// collision only from one, for on its other side the new motion goes on. Refused samples do not move the
/// filter; after 0.7 s of refusals it begins anew. While a filter is still learning the velocity the other
/// direction decides alone.
std::vector<bool> refusedFromBothSides(std::span<const TrackNode> track, MotionNoise noise);

/// Sets Jump, with SpeedLimit and AccelerationLimit as further reasons, on samples that no robot's motion
/// explains. Returns the noise estimated from what remains.
MotionNoise flagSpikes(std::vector<Sample> &samples, const AnalysisOptions &options);

/// The flagged measurements in words with figures, e.g. "jump of 212 mm". Times without a measurement (lost,
/// repeated pictures) are gaps, not spikes, and are not listed. points: the profile of the same samples.
std::vector<Spike> describeSpikes(const FusedTrack &track, const std::vector<ProfilePoint> &points);

} // namespace odo
