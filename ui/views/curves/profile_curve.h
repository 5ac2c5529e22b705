// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/curve_columns.h"
#include "core/analysis/quantity_curve.h"
#include "ui/views/curves/chart_content.h"

#include <QString>
#include <optional>
#include <vector>

namespace odo {

/// quantityValues in the unit that people read (curveUnit).
std::vector<std::optional<CurveValue>> curveValues(const Profile &profile, Quantity quantity);
/// "m/s", "m/s²", "mm" or as shown_units.h has it; "°", "°/s".
QString curveUnit(Quantity quantity);
/// By how much a value in SI is multiplied for curveUnit.
double curveFactor(Quantity quantity);

/// When each sample was taken, in seconds: its place where the axis below is the time.
std::vector<double> sampleTimes(const Profile &profile);

/// From the lowest to the highest value of the lines among curves, with their bands as long as those do not
/// press the lines flat; 0 is contained unless they are places.
ValueRange valueRange(const std::vector<ChartCurve> &curves, Quantity quantity);

/// measuredValues at the places of the samples, in the unit of curveUnit, without bands; empty for the turn
/// rate.
CurveRun measuredPoints(const Profile &profile, Quantity quantity, const std::vector<double> &places);

/// The spikes of a curve of speed, where they were measured or else where the curve is; empty for every other
/// quantity.
CurveRun spikePoints(const Profile &profile, Quantity quantity, const std::vector<double> &places);

/// The robot's curve of a quantity as a chart shows it, in the colour of a place and the dash of the group;
/// and its measured points (beneath) and spikes (above), of the same group.
struct ProfileCurves
{
    ChartCurve measured, line, spikes;
};
ProfileCurves profileCurves(const Profile &profile, Quantity quantity, const std::vector<double> &places,
                            int group = 0, int place = 0);

} // namespace odo
