// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/kalman_smoother.h"

#include <vector>

namespace odo {

/// What is known of the motion once the spikes are separated from it.
struct SpikeVerdict
{
    MotionNoise noise;                 ///< of what remains, with the slow part of the measurement's
    double usualDensity = 0;           ///< as adaptToMotion wants it
    MotionNoise searchNoise;           ///< with which the spikes were searched
    std::vector<MotionChange> changes; ///< of each sample: what to smooth the track with
};

/// Sets Jump, with SpeedLimit and AccelerationLimit as further reasons, on samples that no robot's motion
/// explains (searchSpikes, with the noise learnt from the run itself; Hampel's identifier gives the first
/// guess), and on those that Hampel's identifier on position or speed finds and that are farther from the
/// smoothed track of all than their noise allows; AccelerationLimit alone on those that break a limit of the
/// task (refuseBeyondTask). Samples that a person has judged (ByHand) are left as they are. A collision, a
/// start and a bounce are motions.
SpikeVerdict flagSpikes(std::vector<Sample> &samples, const AnalysisOptions &options,
                        const MeasurementNoise &measurement = {});

/// The same with both noises known, from another part of the track: one search. Gives how the motion changed
/// on the way to each sample.
std::vector<MotionChange> flagSpikesKnowing(const SpikeVerdict &known, std::vector<Sample> &samples,
                                            const AnalysisOptions &options);

/// The flagged measurements in words with values, e.g. "jump of 212 mm; spike in position and speed". Times
/// without a measurement (lost, repeated frames) are gaps, not spikes, and are not listed. points: the
/// profile of the same samples.
std::vector<Spike> describeSpikes(const FusedTrack &track, const std::vector<ProfilePoint> &points,
                                  Nanoseconds longestGap);

} // namespace odo
