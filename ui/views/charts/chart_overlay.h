// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/explanation.h"
#include "ui/views/curves/chart_content.h"

#include <QColor>
#include <QList>
#include <QObject>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <functional>

class QAbstractScrollArea;
class QPainter;
class QPalette;
class QWidget;

namespace odo {

/// What moves over a chart: the cursor with its values, the selected range, the crosshair. Painted on the
/// chart's image, so that moving it costs no new curves. Any thread.

/// The dotted line at the present position.
void drawChartCursor(QPainter &painter, const ChartPlot &plot, double x, const QPalette &palette);

/// A light shade from one position to another, with a line at either end.
void drawChartRange(QPainter &painter, const ChartPlot &plot, double from, double to,
                    const QPalette &palette);

/// A veil over what is before one position and after another: the outside of the trial's range.
void drawChartOutside(QPainter &painter, const ChartPlot &plot, double from, double to,
                      const QPalette &palette);

/// The frame of a chart or map while it has the focus; none in images of it.
void drawChartFocus(QPainter &painter, const QWidget &plot);

/// A value beside the cursor, `top` from the upper end of the widget, and a dot on its curve. Gives the
/// position of its bubble; the next one goes bubbleGap below it.
QRectF drawChartBubble(QPainter &painter, const ChartPlot &plot, const QPointF &value, double top,
                       const QString &text, const QColor &colour, const QPalette &palette);
constexpr double bubbleGap = 3;

/// Thin lines through a position of the plot, with its value on either axis in a box each.
void drawCrosshair(QPainter &painter, const ChartPlot &plot, const QPointF &position, const QString &below,
                   const QString &left, const QPalette &palette);

/// The bubbles that a chart shows at its cursor. Each explains how its value was computed: by a click on it;
/// the uppermost also by Enter or Shift+F1 while the chart has the focus.
class ChartBubbles : public QObject
{
    Q_OBJECT
public:
    explicit ChartBubbles(QAbstractScrollArea &chart);
    /// Call it whenever the chart is painted: what is shown now, from above.
    void clear() { m_bubbles.clear(); }
    void add(const QRectF &position, std::function<Explanation()> how);
    /// Their positions, in the chart's coordinates.
    QList<QRectF> positions() const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Bubble
    {
        QRectF position;
        std::function<Explanation()> how;
    };
    const Bubble *at(const QPointF &point) const;
    void explain(const Bubble &bubble) const;

    QAbstractScrollArea &m_chart;
    QList<Bubble> m_bubbles;
    bool m_isPressed = false; ///< what follows until the button is released is not the chart's
};

} // namespace odo
