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
/// "m/s", "m/s²", "mm" or as shown_units.h has it; "°", "°/s".
QString curveUnit(Quantity quantity);
/// By how much a value in SI is multiplied for curveUnit.
double curveFactor(Quantity quantity);

/// When each sample was taken, in seconds: its place where the axis below is the time.
std::vector<double> sampleTimes(const Profile &profile);

/// A stretch without gaps. x: the places of the samples, y: as of curveValues.
struct CurveRun
{
    QList<QPointF> line, upper, lower; ///< of equal length; the 95 % band (1.96 σ)
};
/// values: curveValues of the quantity. places: one a sample (ChartSpan::places).
std::vector<CurveRun> curveRuns(const std::vector<std::optional<CurveValue>> &values, Quantity quantity,
                                const std::vector<double> &places);

/// From the lowest to the highest value of curves, with their bands as long as those do not press the curves
/// flat; 0 is contained unless they are places.
struct ValueRange
{
    double low = 0, high = 1;
};
ValueRange valueRange(const std::vector<const CurveRun *> &runs, Quantity quantity);

/// measuredValues as points at the places of the samples, in the unit of curveUnit; empty for the turn rate.
QList<QPointF> measuredPoints(const Profile &profile, Quantity quantity, const std::vector<double> &places);

/// The spikes of a curve of speed, where they were measured or else where the curve is; empty for every other
/// quantity.
QList<QPointF> spikePoints(const Profile &profile, Quantity quantity, const std::vector<double> &places);

} // namespace odo
