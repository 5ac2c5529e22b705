// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/explanation.h"

#include <QList>
#include <QObject>
#include <QRectF>
#include <functional>

class QAbstractScrollArea;

namespace odo {

/// The bubbles that a chart shows at its cursor. Each tells how its value was computed: by a click on it; the
/// uppermost also by Enter or Shift+F1 while the chart has the focus.
class ChartBubbles : public QObject
{
    Q_OBJECT
public:
    explicit ChartBubbles(QAbstractScrollArea &chart);
    /// To be called whenever the chart is painted: what stands there now, from above.
    void clear() { m_bubbles.clear(); }
    void add(const QRectF &place, std::function<Explanation()> how);
    /// Where they stand, in the chart's coordinates.
    QList<QRectF> places() const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Bubble
    {
        QRectF place;
        std::function<Explanation()> how;
    };
    const Bubble *at(const QPointF &point) const;
    void explain(const Bubble &bubble) const;

    QAbstractScrollArea &m_chart;
    QList<Bubble> m_bubbles;
    bool m_isPressed = false; ///< what follows until the button is released is not the chart's
};

} // namespace odo
