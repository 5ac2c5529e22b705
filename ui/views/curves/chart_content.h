// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"
#include "ui/models/number_text.h"

#include <QPointF>
#include <QRectF>
#include <QString>
#include <Qt>
#include <algorithm>
#include <memory>
#include <vector>

namespace odo {

/// What a chart shows, as plain values that any thread can make. Colours are named by what they stand for, so
/// that a chart follows the palette.

/// The colour of a curve: that of a series (seriesColour of its index), or one of the theme.
enum class ChartInk { Series, Muted, Point, Text, Accent, Spike, Ground };

/// Lines, points or spikes of one thing.
struct ChartCurve
{
    enum class Kind {
        Line,   ///< with its band, where it has one
        Points, ///< a dot each
        Spikes, ///< a triangle each; beyond the axis it is at its end: each must be visible
        Bars    ///< from 0 to the value, 0.8 wide
    };
    Kind kind = Kind::Line;
    std::vector<CurveRun> runs; ///< in order; x in SI units, values in the unit that is shown
    ChartInk ink = ChartInk::Series;
    int position = 0; ///< of a series' colour
    Qt::PenStyle dash = Qt::SolidLine;
    double widthPx = 1.8; ///< of lines; of points about a third of their size
    bool hasBand = false;
    Qt::BrushStyle fill = Qt::SolidPattern; ///< of bars; Qt::NoBrush: their outline alone
    int group = 0; ///< curves of one group are shown and hidden together (Chart::setGroupShown)
};

/// A stretch of the axis below that is shaded: less than usual is known there.
struct ChartStretch
{
    double from = 0, to = 0;
    bool isHatched = false; ///< the robot is ambiguous
};

/// The range of the axis at the left, in the unit that is shown.
struct ValueRange
{
    double low = 0, high = 1;
};

struct ChartContent
{
    std::vector<ChartCurve> curves; ///< the first one lies beneath
    ValueRange range;               ///< that holds all curves
    QString emptyWords;             ///< shown in place of curves; empty: nothing
};
using ChartContentPtr = std::shared_ptr<const ChartContent>;

/// What kind of axes a chart has.
enum class ChartStyle {
    Plot,  ///< an amount below, values at the left
    Dates, ///< below are milliseconds since 1970 (UTC), shown as days
    Strip, ///< amounts above, with lines down through rows; nothing at the left, and no margins
    Bars   ///< things from 0 on below, without a scale; values at the left
};

/// What the axes stand for.
struct ChartAxes
{
    ShownUnit below{QStringLiteral("s"), 1}; ///< of the axis below
    QString left;                            ///< title of the axis at the left: a unit, or what is shown
    ChartStyle style = ChartStyle::Plot;
};

/// What of a chart is shown, all that it takes to paint it (chart_drawing.h).
struct ChartDrawing
{
    ChartContentPtr content;
    ChartAxes axes;
    double low = 0, high = 1; ///< of the axis below, SI
    std::vector<ChartStretch> stretches;
};

/// Where the values of a chart lie: a value, taken from a Chart, for what is painted over it.
struct ChartPlot
{
    QRectF rect;              ///< of the plot, in the chart's coordinates
    double low = 0, high = 1; ///< of the axis below, SI
    ValueRange values;

    QPointF at(double x, double value) const
    {
        return {rect.left() + (x - low) / (high - low) * rect.width(),
                rect.bottom() - (value - values.low) / (values.high - values.low) * rect.height()};
    }
    /// Kept within low and high.
    double xAt(double screenX) const
    {
        const double part = std::clamp((screenX - rect.left()) / std::max(1.0, rect.width()), 0.0, 1.0);
        return low + part * (high - low);
    }
    double valueAt(double screenY) const
    {
        const double part = (rect.bottom() - screenY) / std::max(1.0, rect.height());
        return values.low + std::clamp(part, 0.0, 1.0) * (values.high - values.low);
    }
};

} // namespace odo
