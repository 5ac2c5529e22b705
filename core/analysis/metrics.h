// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/motion_stretches.h"
#include "core/analysis/profile.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace odo {

/// Metrics of a whole run, always in this order and with these names: duration (s, from the onset of motion
/// to the last stop), path_length (m), mean_speed (m/s, path_length over duration), max_speed, rms_speed
/// (m/s), max_accel, rms_accel (m/s²), straightness (1, end to end over path_length), moving_time (s), stops
/// (1, pauses between onset and end), standing_time (s, in those pauses), median_speed, p95_speed (m/s),
/// p95_accel (m/s²; half and 95 % of the moving time stay below them), where any is known max_turn_rate
/// (rad/s, either way: turnRateOf, of the body also while the robot stands), and where the path is a circle
/// circle_radius (m, fitCircle). Moving means as findMotions says it (motion_stretches.h); the moments
/// between frames are interpolated. Only the speed while moving is integrated, so noise adds nothing to the
/// path of a robot that stands still. A gap (GapWatch) contributes to the duration alone: all others are of
/// what was measured, mean_speed over the measured time, a pause that a gap interrupts is no stop, and
/// straightness is left out. Bridged points are no evidence of a stop or a maximum. σ: from the profile's σ,
/// with what the robot could have done in gaps and bridged stretches (internal/bridging.h); the calibration's
/// part as a common scale uncertainty. A
/// maximum is that of the smoothed curve (see largest). A robot that never moves has a duration of 0, and 0
/// for all that depends on it.
std::vector<Metric> measureRun(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points);
std::vector<Metric> measureRun(const std::vector<RunInstant> &instants);

/// The value of a metric by its name; 0 where it could not be computed.
double metricValue(const Profile &profile, std::string_view name);

/// Sets Metric::isAtLeast of those that a gap can only make larger, where the run has gaps.
void markLowerBounds(std::vector<Metric> &metrics, const std::vector<TimeSpan> &gaps);

/// The calibration's relative scale uncertainty: σ of each length, speed and acceleration among the metrics
/// contains its value times this. 0 without a valid point.
double sigmaOfScale(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points);

struct CircleFit
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radiusM = 0;
    double sigmaRadiusM = 0; ///< of the points' scatter alone, without the calibration's scale uncertainty
    double rmsM = 0;         ///< of the points' distances from the circle
};

/// The circle with the least squared distances from points in order along a path (algebraic start: Kåsa 1976;
/// then Gauss–Newton on the distances). σ from the scatter of the distances; neighbours' errors are
/// correlated, so they count as fewer: by 1 + 2Σρₖ of the distances' autocorrelation up to its first change
/// of sign. nullopt when the path is no circle: fewer than ten points, less than a third of a turn, or
/// distances of more than 3 % of the radius.
std::optional<CircleFit> fitCircle(std::span<const Eigen::Vector2d> path);

/// A value of a curve with its standard deviation.
struct UncertainValue
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

/// Root mean square over the motions' instants; σ: the bound for fully correlated errors. 0 for none.
UncertainValue rootMeanSquare(const std::vector<RunInstant> &instants,
                              const std::vector<MotionStretch> &motions, Curve curve);

/// What lies so near to a percentile decides it.
inline constexpr double sigmasNearPercentile = 1.5;

/// The value that a share of the motions' time stays below. The stretches within 1.5 σ of it decide it, each
/// by its mean, whose error is that of the integral at both ends over the stretch's time, and the value's own
/// σ at most; stretches independent of one another, weighted by time. 0 for none.
UncertainValue percentile(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions,
                          Curve curve, double share);

/// The instant of the largest significant value: by value minus three σ, so a badly known point (at the ends,
/// in a gap) does not win because of its uncertainty. instants must not be empty.
const RunInstant &largest(const std::vector<RunInstant> &instants, Curve curve);

} // namespace odo
