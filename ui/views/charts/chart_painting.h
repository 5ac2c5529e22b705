// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/figure_text.h"

#include <QColor>
#include <QList>
#include <QLocale>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <vector>

class QFont;
class QPainter;
class QPalette;
class QWidget;

namespace odo {

/// Where an axis puts its marks: round numbers (1, 2 or 5 times a power of ten) that cover a range.
struct AxisTicks
{
    double first = 0, step = 1; ///< step > 0
    int count = 0;              ///< marks; the last is first + (count − 1) · step
    int decimals = 0;           ///< that the labels need

    std::vector<double> values() const;
    double last() const { return first + (count - 1) * step; }
    QString label(double value, const QLocale &locale = QLocale()) const;
};

/// Marks inside [low, high], at most about `most` of them.
AxisTicks niceTicks(double low, double high, int most);
/// Marks that reach to or beyond both ends of [low, high].
AxisTicks coveringTicks(double low, double high, int most);

/// Where the values of a chart lie on the screen.
struct ChartPlot
{
    /// All charts have the same margins, so that their times or distances stand below one another.
    static constexpr double leftMargin = 52, rightMargin = 14, topMargin = 10, bottomMargin = 26;
    static QRectF rectIn(const QRectF &widget)
    {
        return widget.adjusted(leftMargin, topMargin, -rightMargin, -bottomMargin);
    }

    QRectF rect;
    double low = 0, high = 1; ///< of the axis below
    AxisTicks values;         ///< of the axis at the left
    /// columns to a unit of rect, in which many points are drawn as one: more for print
    double fineness = 1;

    QPointF at(double x, double value) const;
    double xAt(double screenX) const; ///< kept within low and high
};

/// A line for each value with its number, and the numbers below in their unit.
void drawChartAxes(QPainter &painter, const ChartPlot &plot, const ShownUnit &below, const QFont &font,
                   const QPalette &palette);

/// The dotted line at the present place.
void drawChartCursor(QPainter &painter, const ChartPlot &plot, double x, const QPalette &palette);

/// A light shade from one place to another, with a line at either end.
void drawChartRange(QPainter &painter, const ChartPlot &plot, double from, double to,
                    const QPalette &palette);

/// A quiet shade from one place to another in which less than usual is known; hatched: it is doubtful which
/// robot it is.
void drawChartDoubt(QPainter &painter, const ChartPlot &plot, double from, double to, bool isHatched,
                    const QPalette &palette);

/// A triangle for each spike that is visible; one beyond the axis at the left stands at its end, for every
/// spike is to be seen.
void drawChartSpikes(QPainter &painter, const ChartPlot &plot, const QList<QPointF> &spikes,
                     const QPalette &palette);

/// A dashed line over the curves, within the plot.
void drawChartFit(QPainter &painter, const ChartPlot &plot, const QList<QPointF> &values,
                  const QPalette &palette);

/// The frame of a chart or map while it has the focus; none in pictures of it.
void drawChartFocus(QPainter &painter, const QWidget &plot);

/// A value beside the cursor, `top` from the upper end of the widget, and a dot on its curve. Gives where its
/// bubble stands; the next one goes bubbleGap below it.
QRectF drawChartBubble(QPainter &painter, const ChartPlot &plot, const QPointF &value, double top,
                       const QString &text, const QColor &colour, const QPalette &palette);
constexpr double bubbleGap = 3;

} // namespace odo
