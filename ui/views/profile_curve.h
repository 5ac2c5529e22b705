// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"
#include "ui/views/profile_chart.h"

#include <QList>
#include <QPointF>
#include <optional>

namespace odo {

/// A value of a quantity with its σ.
struct CurveValue
{
    double value = 0, sigma = 0;
};

/// The values of a quantity at all points of a profile; nullopt where it has none. Speed: |v|. Acceleration:
/// along the path, a·v/|v|, so that braking is negative; |a| while it stands. Heading: of the motion, without
/// steps of a whole turn, while it stands the last one with a σ of 0. Turn rate: none while it stands. m/s,
/// m/s², degrees, degrees a second: what people read.
std::vector<std::optional<CurveValue>> curveValues(const Profile &profile, Quantity quantity);
/// "m/s", "m/s²", "°", "°/s".
QString curveUnit(Quantity quantity);

/// A stretch without gaps. x: seconds, y: as of curveValues.
struct CurveRun
{
    QList<QPointF> line, upper, lower; ///< of equal length; the 95 % band (1.96 σ)
};
std::vector<CurveRun> curveRuns(const Profile &profile, Quantity quantity);

/// The speed by central differences of the unsmoothed positions (Tracker's way), for samples that are not
/// rejected and whose neighbours are there. Empty for what takes two differences or an angle of noise.
QList<QPointF> measuredPoints(const Profile &profile, Quantity quantity);
/// As measuredPoints for one sample, rejected or not.
std::optional<double> measuredSpeed(const Profile &profile, std::size_t sample);

/// The smoothed value at a time; nullopt in gaps.
std::optional<CurveValue> curveValueAt(const Profile &profile, Quantity quantity, Nanoseconds time);

} // namespace odo
