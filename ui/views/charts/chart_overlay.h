// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/charts/internal/chart_plot.h"

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>

class QPainter;
class QPalette;
class QWidget;

namespace odo {

/// What stands over a chart and moves: the cursor with its values, the selected range, the crosshair. Painted
/// on the chart's picture, so that moving it costs no new curves. Any thread.

/// The dotted line at the present place.
void drawChartCursor(QPainter &painter, const ChartPlot &plot, double x, const QPalette &palette);

/// A light shade from one place to another, with a line at either end.
void drawChartRange(QPainter &painter, const ChartPlot &plot, double from, double to,
                    const QPalette &palette);

/// The frame of a chart or map while it has the focus; none in pictures of it.
void drawChartFocus(QPainter &painter, const QWidget &plot);

/// A value beside the cursor, `top` from the upper end of the widget, and a dot on its curve. Gives where its
/// bubble stands; the next one goes bubbleGap below it.
QRectF drawChartBubble(QPainter &painter, const ChartPlot &plot, const QPointF &value, double top,
                       const QString &text, const QColor &colour, const QPalette &palette);
constexpr double bubbleGap = 3;

/// Thin lines through a place of the plot, with what it stands for on both axes in a box each.
void drawCrosshair(QPainter &painter, const ChartPlot &plot, const QPointF &place, const QString &below,
                   const QString &left, const QPalette &palette);

} // namespace odo
