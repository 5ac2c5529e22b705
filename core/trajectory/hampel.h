// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/kalman_smoother.h"

#include <span>
#include <vector>

namespace odo {

/// The middle value, of an even number the mean of the two; 0 for none.
double median(std::vector<double> values);

/// Median absolute deviation from the median, times 1.4826: the standard deviation of a normal distribution.
double medianDeviation(const std::vector<double> &values);

struct HampelSettings
{
    int halfWindow = 3;        ///< values looked at on each side
    double threshold = 3;      ///< in standard deviations
    double leastDeviation = 0; ///< the standard deviation is never taken as less: equal neighbours have none
};

/// Hampel's identifier (Hampel 1974; Davies and Gather 1993): values further from the median of their window
/// than the threshold times the window's median deviation. At the ends the window has the values that there
/// are. Pure.
std::vector<bool> hampelOutliers(std::span<const double> values, const HampelSettings &settings);

/// How a measurement stands out from its neighbours.
struct HampelSpike
{
    bool byPosition = false;
    bool bySpeed = false; ///< by the speeds to both neighbours
    bool any() const { return byPosition || bySpeed; }
};

/// Measurements of a track that stand out by their position, or by the speeds to both their neighbours, in a
/// window of seven. A guess that needs no model of motion: it finds single outliers, not bursts.
std::vector<HampelSpike> hampelSpikes(std::span<const TrackNode> track);

} // namespace odo
