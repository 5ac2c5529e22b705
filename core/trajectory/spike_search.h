// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/kalman_smoother.h"

#include <span>
#include <vector>

namespace odo {

/// What a track's measurements are, as long as the track.
struct SpikeSearch
{
    std::vector<bool> spike; ///< measurements that no motion explains
    std::vector<bool>
        abrupt; ///< the motion changed abruptly before this measurement: a collision, a hard start
    std::vector<bool> struck; ///< of these the ones whose velocity did: a blow
};

/// The cheapest explanation of a whole track. Each measurement either follows the motion before it, or
/// follows an abrupt change of acceleration or of velocity (a robot may collide, start, stop; it goes on from
/// where it was), or is a spike; spikes that follow one another are cheaper than spikes apart. A position
/// never jumps: a track that goes aside and comes back in steps is therefore a burst of spikes, while one
/// that goes on in another direction is a collision. The cost is −2 log likelihood of the innovations of a
/// Kalman filter, plus a price for each abrupt change and spike; explanations are followed side by side
/// (multiple hypotheses: Reid 1979) and the dear ones dropped. maxSpeedMps: a step faster than that is no
/// motion. Pure; time linear in the length.
SpikeSearch searchSpikes(std::span<const TrackNode> track, MotionNoise noise, double maxSpeedMps);

} // namespace odo
