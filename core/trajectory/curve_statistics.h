// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/motion_stretches.h"

#include <vector>

namespace odo {

/// A figure of a curve with its standard deviation.
struct Figure
{
    double value = 0, sigma = 0;
};

/// One curve of a profile, its σ, and the σ of its integral (of a speed: the position's; of an acceleration:
/// the speed's), which says how fast errors average out over time.
struct Curve
{
    double ProfilePoint::*value;
    double ProfilePoint::*sigma;
    double (*sigmaOfIntegral)(const RunInstant &);
};
extern const Curve speedCurve, accelCurve;

/// Root mean square over the motions' instants; σ: the bound for errors that all go together. 0 for none.
Figure rootMeanSquare(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions,
                      Curve curve);

/// What lies so near to a percentile decides it.
inline constexpr double sigmasNearPercentile = 1.5;

/// The value that a share of the motions' time stays below. The stretches within 1.5 σ of it decide it, each
/// by its mean, whose error is that of the integral at both ends over the stretch's time, and the value's own
/// σ at most; stretches independent of one another, weighted by time. 0 for none.
Figure percentile(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions,
                  Curve curve, double share);

/// The instant where the curve is largest beyond doubt: by its value less twice its σ, so that a badly known
/// point (at the ends, in a gap) does not win by its error. The maximum of noisy values is too large by about
/// their σ; of a smoothed curve that is little, and σ is stated. instants must not be empty.
const RunInstant &largest(const std::vector<RunInstant> &instants, Curve curve);

} // namespace odo
