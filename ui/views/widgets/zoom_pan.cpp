// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/zoom_pan.h"

#include <QApplication>
#include <QGestureEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QStyleHints>
#include <QWheelEvent>
#include <QWidget>
#include <cmath>

namespace odo {

namespace {

constexpr double stepFactor = 1.5;
constexpr double wheelPerDouble = 240; ///< eighths of a degree: two notches make it twice as large

} // namespace

ZoomPan::ZoomPan(QWidget &view) : QObject(&view), m_view(view)
{
    view.installEventFilter(this);
    view.grabGesture(Qt::PinchGesture);
}

void ZoomPan::setFrame(const QRectF &fitted, double mostScale)
{
    m_state.setFrame(fitted, QRectF(m_view.rect()), mostScale);
}

void ZoomPan::zoomBy(double factor, const QPointF &anchor)
{
    if (m_state.zoomBy(factor, anchor))
        Q_EMIT changed();
}

QPointF ZoomPan::anchor() const
{
    const QPointF mouse = m_view.mapFromGlobal(QPointF(QCursor::pos()));
    return m_view.underMouse() && m_view.rect().contains(mouse.toPoint()) ? mouse
                                                                          : QRectF(m_view.rect()).center();
}

void ZoomPan::zoomIn()
{
    zoomBy(stepFactor, anchor());
}

void ZoomPan::zoomOut()
{
    zoomBy(1 / stepFactor, anchor());
}

void ZoomPan::fit()
{
    if (m_state.fit())
        Q_EMIT changed();
}

bool ZoomPan::press(const QMouseEvent &event)
{
    const bool isMiddle = event.button() == Qt::MiddleButton;
    const bool isFree = event.button() == Qt::LeftButton && !m_state.isFitted() &&
                        (!m_mayDrag || m_mayDrag(event.position()));
    m_isDragging = false;
    m_last = isMiddle || isFree ? std::optional(event.position()) : std::nullopt;
    return isMiddle; // a left click is still the widget's own
}

bool ZoomPan::move(const QMouseEvent &event)
{
    if (!m_last)
        return false;
    const QPointF by = event.position() - *m_last;
    if (!m_isDragging) {
        if (by.manhattanLength() < QGuiApplication::styleHints()->startDragDistance())
            return false;
        m_isDragging = true;
        m_before = m_view.cursor();
        m_view.setCursor(Qt::ClosedHandCursor);
    }
    m_last = event.position();
    if (m_state.panBy(by))
        Q_EMIT changed();
    return true;
}

bool ZoomPan::release()
{
    m_last.reset();
    if (!std::exchange(m_isDragging, false))
        return false;
    m_view.setCursor(m_before);
    return true;
}

/// By two fingers, on a touch pad or on the screen.
bool ZoomPan::pinch(QEvent &event)
{
    if (event.type() == QEvent::NativeGesture) {
        const auto &native = static_cast<QNativeGestureEvent &>(event);
        if (native.gestureType() != Qt::ZoomNativeGesture)
            return false;
        zoomBy(1 + native.value(), native.position());
        return true;
    }
    const auto *fingers =
        static_cast<QPinchGesture *>(static_cast<QGestureEvent &>(event).gesture(Qt::PinchGesture));
    if (!fingers)
        return false;
    if (fingers->changeFlags().testFlag(QPinchGesture::ScaleFactorChanged))
        zoomBy(fingers->scaleFactor(), m_view.mapFromGlobal(fingers->centerPoint()));
    return true;
}

bool ZoomPan::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::Wheel: {
        const auto *wheel = static_cast<QWheelEvent *>(event);
        zoomBy(std::exp2(wheel->angleDelta().y() / wheelPerDouble), wheel->position());
        event->accept();
        return true;
    }
    case QEvent::NativeGesture:
    case QEvent::Gesture:
        return pinch(*event);
    case QEvent::MouseButtonPress:
        Q_EMIT used();
        return press(*static_cast<QMouseEvent *>(event));
    case QEvent::MouseMove:
        return move(*static_cast<QMouseEvent *>(event));
    case QEvent::MouseButtonRelease:
        return release();
    case QEvent::MouseButtonDblClick:
        if (static_cast<QMouseEvent *>(event)->button() != Qt::LeftButton)
            return false;
        Q_EMIT doubleClicked();
        return true;
    case QEvent::Enter:
    case QEvent::FocusIn:
        Q_EMIT used();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace odo
