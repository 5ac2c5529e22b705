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

/// Speed: |v|. Acceleration: along the path, a·v/|v|, so that braking is negative; |a| while it stands.
CurveValue curveValue(const ProfilePoint &point, Quantity quantity);

/// A stretch without gaps. x: seconds, y: in SI.
struct CurveRun
{
    QList<QPointF> line, upper, lower; ///< of equal length; the 95 % band (1.96 σ)
};
std::vector<CurveRun> curveRuns(const Profile &profile, Quantity quantity);

/// The speed by central differences of the unsmoothed positions (Tracker's way), for samples that are not
/// rejected and whose neighbours are there. Empty for the acceleration: two differences of noise tell
/// nothing.
QList<QPointF> measuredPoints(const Profile &profile, Quantity quantity);
/// As measuredPoints for one sample, rejected or not.
std::optional<double> measuredSpeed(const Profile &profile, std::size_t sample);

/// The smoothed value at a time; nullopt in gaps.
std::optional<CurveValue> curveValueAt(const Profile &profile, Quantity quantity, Nanoseconds time);

} // namespace odo
