// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/quantity_curve.h"

#include <QList>
#include <QPointF>
#include <QString>
#include <optional>

namespace odo {

/// quantityValues in the unit that people read (curveUnit).
std::vector<std::optional<CurveValue>> curveValues(const Profile &profile, Quantity quantity);
/// "m/s", "m/s²", "°", "°/s", "mm".
QString curveUnit(Quantity quantity);
/// By how much a value in SI is multiplied for curveUnit.
double curveFactor(Quantity quantity);

/// A stretch without gaps. x: seconds, y: as of curveValues.
struct CurveRun
{
    QList<QPointF> line, upper, lower; ///< of equal length; the 95 % band (1.96 σ)
};
std::vector<CurveRun> curveRuns(const Profile &profile, Quantity quantity);

/// measuredValues as points, in the unit of curveUnit; empty for the turn rate.
QList<QPointF> measuredPoints(const Profile &profile, Quantity quantity);

/// The smoothed value at a time; nullopt in gaps.
std::optional<CurveValue> curveValueAt(const Profile &profile, Quantity quantity, Nanoseconds time);

} // namespace odo
