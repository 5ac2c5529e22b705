// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/percentile.h"
#include "core/trajectory/internal/kalman_smoother.h"

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

/// Median absolute deviation from the median, times 1.4826: the standard deviation of a normal distribution.
double medianDeviation(const std::vector<double> &values);

struct HampelSettings
{
    int halfWindow = 3;        ///< values used on each side
    double threshold = 3;      ///< in standard deviations
    double leastDeviation = 0; ///< the standard deviation is never taken as less: equal neighbours have none
};

/// Hampel's identifier (Hampel 1974; Davies and Gather 1993): values further from the median of their window
/// than the threshold times the window's median deviation. At the ends the window has the values that there
/// are. Pure.
std::vector<bool> hampelOutliers(std::span<const double> values, const HampelSettings &settings);

/// How a measurement is an outlier among its neighbours.
struct HampelSpike
{
    bool byPosition = false;
    bool bySpeed = false; ///< by the speeds to both neighbours
    bool any() const { return byPosition || bySpeed; }
};

/// Measurements of a track that are outliers in position, or in the speeds to both their neighbours, in a
/// window of seven. A guess that needs no model of motion: it finds single outliers, not bursts.
std::vector<HampelSpike> hampelSpikes(std::span<const TrackNode> track);

} // namespace odo
