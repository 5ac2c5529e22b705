// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/curve_fit.h"
#include "core/analysis/quantity_curve.h"
#include "core/base/units.h"

#include <optional>
#include <vector>

namespace odo {

/// A value and when it is reached.
struct TimedValue
{
    double timeS = 0;
    CurveValue value;
};

/// Statistics of a quantity over a span. World frame, SI. σ takes into account that the smoothed curve's
/// errors are correlated (ErrorCourse), and, except for angles, the calibration's scale uncertainty (for a
/// position, its position uncertainty).
struct RangeStatistics
{
    CurveValue mean;        ///< over the time
    CurveValue median;      ///< half of the time stays below it
    TimedValue least, most; ///< significant: by the value plus, minus, twice its σ, as top speed is chosen
    CurveValue spread;      ///< standard deviation of the curve over the time
    std::size_t points = 0;
};

/// How the errors of a quantity's smoothed curve are correlated.
ErrorCourse errorCourseOf(Quantity quantity);

/// The smoothed curve of a quantity within a span; the position's σ without the calibration's part.
std::vector<CurvePoint> pointsWithin(const Profile &profile, Quantity quantity, const TimeSpan &span,
                                     OtherProfiles others = {});
/// The positions that were measured and are used, of one axis (PositionX, PositionY), with their own σ.
std::vector<CurvePoint> measurementsWithin(const Profile &profile, Quantity quantity, const TimeSpan &span);

/// others: as of quantityValues. nullopt when the quantity has no value there. Each value counts for half the
/// time to both neighbours.
std::optional<RangeStatistics> statisticsOf(const Profile &profile, Quantity quantity, const TimeSpan &span,
                                            OtherProfiles others = {});

/// The distance travelled within a span, as the metric path_length (measureRun of the span alone). nullopt
/// without a valid point there.
std::optional<CurveValue> pathWithin(const Profile &profile, const TimeSpan &span);

/// fitCurve of a quantity over a span: of a position to what was measured, of the others to the smoothed
/// curve. A position's covariance is that of its own measurements or that of the smoothed curve, which knows
/// the lasting part of their errors: the larger one. The calibration's scale uncertainty is added to the
/// variances of the coefficients (its position uncertainty to a position's first one); for angles it is not
/// known and not included. For an acceleration from raw differences (Smoother::None) σ does not contain its
/// bias. Errors: those of fitCurve.
Result<CurveFit> fitQuantity(const Profile &profile, Quantity quantity, const TimeSpan &span, FitShape shape,
                             OtherProfiles others = {});

} // namespace odo
