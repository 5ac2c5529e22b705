// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/charts/internal/chart_plot.h"
#include "ui/views/curves/chart_content.h"

class QFont;
class QPainter;
class QPalette;
class QRectF;

namespace odo {

/// Paints a chart into a rectangle of a page or picture, by the class that the screen's charts are of; gives
/// where its values lie there. Any thread: the chart itself is made on the window's thread (window_thread.h)
/// while the caller waits. fineness: columns to a unit of the rectangle in which many points are drawn as
/// one.
ChartPlot drawChart(QPainter &painter, const QRectF &rect, const ChartDrawing &drawing,
                    const QPalette &palette, const QFont &font, double fineness = 3);

} // namespace odo
