// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/evaluation/internal/measured_course.h"
#include "core/analysis/evaluation/log_evaluation.h"

#include <optional>
#include <vector>

namespace odo {

/// A clock that fits a log to a measured run, with how well it does.
struct LogClockFit
{
    LogClock clock;
    double scale = 1;           ///< metres of the run for one of the log
    std::vector<double> leftM2; ///< variance of a coordinate that is left in each stretch
    double independent = 0;     ///< as so many independent coordinates
};

/// Whether a second fit leaves no more than chance makes of a first one: the means of what is left in their
/// stretches, of which one that does not fit at all counts as 16 usual ones.
bool fitsAlike(const LogClockFit &best, const LogClockFit &other);
/// What the first criterion compares: the mean, with the usual of `best`.
double meanLeftM2(const LogClockFit &fit, double usualM2);

/// Refines an offset by the positions: least squares over stretches of two seconds (longer of slow logs), in
/// each of which the log is turned and shifted by itself, with one scale for all. So drift of an odometry,
/// which is slow, moves no offset, and the axes of the log do not matter. Gauss–Newton in offset, rate and
/// logarithm of the scale; stretches that fit badly (wheels that slip, a jump of a localisation) weigh less.
///
/// σ is that of least squares with correlated residuals (Newey & West 1987): their autocovariance is pooled
/// over all stretches. The information is less what noise of the velocities adds to it. The rate is taken
/// beyond 3.5 σ and up to 2 %, unless much of what shows it is in a single stretch. nullopt: too little in
/// common, or it does not converge. Pure.
std::optional<LogClockFit> fitClock(const MeasuredCourse &course, const std::vector<LogPose> &log,
                                    const LogClock &guess, double scale);

/// Whether the motion of a run tells the time: in some stretch its speed or its curvature changes by more
/// than noise. A straight line or a circle at constant speed does not, nor does standing.
bool tellsTime(const MeasuredCourse &course);

/// Offsets of σ above this are not known.
inline constexpr double largestOffsetSigmaS = 0.25;

} // namespace odo
