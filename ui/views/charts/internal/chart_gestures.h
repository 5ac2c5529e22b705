// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

class QRubberBand;
class QWheelEvent;
class QMouseEvent;

namespace odo {

class ChartView;

/// Zooming and panning a chart by hand: the wheel and a pinch show more or less of the axis below, over the
/// axis at the left of that one; Shift with the wheel, a sideways wheel, the middle button or Shift with the
/// left one pan; Ctrl and a drag zoom into a box; a double click shows all. Child of the view. GUI thread.
class ChartGestures : public QObject
{
public:
    explicit ChartGestures(ChartView &view);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool press(const QMouseEvent &event);
    bool move(const QMouseEvent &event);
    bool release(const QMouseEvent &event);
    void turnWheel(const QWheelEvent &event);

    ChartView &m_view;
    std::optional<double> m_pannedX; ///< where the mouse was last, while it pans
    std::optional<QPoint> m_boxFrom; ///< one corner of the box that is drawn
    QRubberBand *m_box;
};

} // namespace odo
