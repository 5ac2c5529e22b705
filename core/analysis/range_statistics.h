// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/curve_fit.h"
#include "core/analysis/quantity_curve.h"
#include "core/base/units.h"

#include <optional>
#include <vector>

namespace odo {

/// A figure and when it is reached.
struct TimedValue
{
    double timeS = 0;
    CurveValue value;
};

/// What is to be said of a quantity over a span. World frame, SI. σ contain that the smoothed curve's errors
/// hang together (ErrorCourse), and, but for angles, what the calibration's error of scale adds (of a
/// position, its error of place).
struct RangeStatistics
{
    CurveValue mean;        ///< over the time
    CurveValue median;      ///< half of the time stays below it
    TimedValue least, most; ///< beyond doubt: by the value plus, minus, twice its σ, as top speed is chosen
    CurveValue spread;      ///< standard deviation of the curve over the time
    std::size_t points = 0;
};

/// How the errors of a quantity's smoothed curve hang together.
ErrorCourse errorCourseOf(Quantity quantity);

/// The smoothed curve of a quantity within a span; the position's σ without the calibration's part.
std::vector<CurvePoint> pointsWithin(const Profile &profile, Quantity quantity, const TimeSpan &span);
/// The positions that were measured and are used, of one axis (PositionX, PositionY), with their own σ.
std::vector<CurvePoint> measurementsWithin(const Profile &profile, Quantity quantity, const TimeSpan &span);

/// nullopt when the quantity has no value there. Each value counts for half the time to both neighbours.
std::optional<RangeStatistics> statisticsOf(const Profile &profile, Quantity quantity, const TimeSpan &span);

/// The way driven within a span, as the metric path_length (measureRun of the span alone). nullopt without a
/// valid point there.
std::optional<CurveValue> pathWithin(const Profile &profile, const TimeSpan &span);

/// fitCurve of a quantity over a span: of a position to what was measured, of the others to the smoothed
/// curve. A position's covariance is that of its own measurements or that of the smoothed curve, which knows
/// what of their errors lasts: the larger one. The calibration's error of scale is added to the variances of
/// the coefficients (to a position's first one its error of place); for angles it is not known and not in
/// them. For an acceleration out of raw differences (Smoother::None) σ does not tell its bias. Errors: those
/// of fitCurve.
Result<CurveFit> fitQuantity(const Profile &profile, Quantity quantity, const TimeSpan &span, FitShape shape);

} // namespace odo
