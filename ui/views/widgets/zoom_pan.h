// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/widgets/zoom_state.h"

#include <QCursor>
#include <QObject>
#include <functional>
#include <optional>
#include <utility>

class QMouseEvent;
class QWidget;

namespace odo {

/// Lets a person look closely at what a widget paints: the wheel and two fingers zoom about the point under
/// them, a drag with the middle button, or with the left one where that is free, moves it. Sees the widget's
/// events before the widget; lives with it. GUI thread.
class ZoomPan : public QObject
{
    Q_OBJECT
public:
    explicit ZoomPan(QWidget &view);

    const ZoomState &state() const { return m_state; }
    /// To be called when the widget has another size, or shows something else; as ZoomState::setFrame.
    void setFrame(const QRectF &fitted, double mostScale);
    /// Where a drag with the left button may begin; everywhere without one.
    void setDragFilter(std::function<bool(const QPointF &position)> filter) { m_mayDrag = std::move(filter); }

    /// By a step, about the mouse where it is over the widget, else about the middle.
    void zoomIn();
    void zoomOut();
    void fit();

Q_SIGNALS:
    void changed(); ///< state()
    void used();    ///< the mouse or the focus came to the widget
    void doubleClicked();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void zoomBy(double factor, const QPointF &anchor);
    QPointF anchor() const;
    bool press(const QMouseEvent &event);
    bool move(const QMouseEvent &event);
    bool release();
    bool pinch(QEvent &event);

    QWidget &m_view;
    ZoomState m_state;
    std::function<bool(const QPointF &)> m_mayDrag;
    std::optional<QPointF> m_last; ///< where the mouse was, while a button that may drag is down
    bool m_isDragging = false;
    QCursor m_before;
};

} // namespace odo
