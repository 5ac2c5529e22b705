// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"
#include "ui/views/charts/chart_painting.h"

#include <QColor>
#include <QList>
#include <QPointF>
#include <QString>
#include <optional>

class QPainter;

namespace odo {

/// quantityValues in the unit that people read (curveUnit).
std::vector<std::optional<CurveValue>> curveValues(const Profile &profile, Quantity quantity);
/// "m/s", "m/s²", "mm" or as shown_units.h has it; "°", "°/s".
QString curveUnit(Quantity quantity);
/// By how much a value in SI is multiplied for curveUnit.
double curveFactor(Quantity quantity);

/// When each sample was taken, in seconds: its place where the axis below is the time.
std::vector<double> sampleTimes(const Profile &profile);

/// A point of a curve with its 95 % band (1.96 σ), in single precision: a trial may have a million of them.
struct BandPoint
{
    BandPoint(double place, const CurveValue &curveValue);
    double x; ///< the place on the axis below
    float value, reach;
    double low() const { return double(value) - double(reach); }
    double high() const { return double(value) + double(reach); }
    CurveValue curveValue() const;
};

/// A stretch without gaps: one point a sample, from firstSample on.
struct CurveRun
{
    std::size_t firstSample = 0;
    std::vector<BandPoint> points;
    bool isLine() const { return points.size() >= 2; }
};
/// values: curveValues of the quantity. places: one a sample (ChartSpan::places).
std::vector<CurveRun> curveRuns(const std::vector<std::optional<CurveValue>> &values,
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

/// How a curve's line is drawn; the band is a haze of its colour.
struct CurvePen
{
    QColor colour;
    Qt::PenStyle dash = Qt::SolidLine;
};

/// The part of a curve that is visible, with its band, within the plot. Where there is more than one point to
/// a pixel column, each column is filled from its lowest to its highest value: as fast for an hour as for a
/// second, and no extreme is lost. Points must be sorted by x.
void drawCurveRun(QPainter &painter, const ChartPlot &plot, const CurveRun &run, const CurvePen &pen);

/// A dot for each point that is visible; of many in a pixel column those of decimated.
void drawCurvePoints(QPainter &painter, const ChartPlot &plot, const QList<QPointF> &points,
                     const QColor &colour);

} // namespace odo
