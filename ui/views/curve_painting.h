// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/chart_painting.h"
#include "ui/views/profile_curve.h"

#include <QColor>
#include <QList>
#include <QPointF>

class QPainter;

namespace odo {

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
