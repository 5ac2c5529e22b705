// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/internal/chart_gestures.h"

#include "ui/views/charts/axis_span.h"
#include "ui/views/charts/chart_view.h"

#include <QApplication>
#include <QGestureEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QRubberBand>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace odo {

ChartGestures::ChartGestures(ChartView &view)
    : QObject(&view), m_view(view), m_box(new QRubberBand(QRubberBand::Rectangle, view.viewport()))
{
    view.viewport()->installEventFilter(this);
    view.viewport()->grabGesture(Qt::PinchGesture);
}

bool ChartGestures::eventFilter(QObject *, QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        return press(*static_cast<QMouseEvent *>(event));
    case QEvent::MouseMove:
        return move(*static_cast<QMouseEvent *>(event));
    case QEvent::MouseButtonRelease:
        return release(*static_cast<QMouseEvent *>(event));
    case QEvent::MouseButtonDblClick:
        if (static_cast<QMouseEvent *>(event)->button() != Qt::LeftButton)
            return false;
        m_view.showAll();
        return true;
    case QEvent::Wheel:
        turnWheel(*static_cast<QWheelEvent *>(event));
        event->accept();
        return true;
    case QEvent::NativeGesture: {
        const auto *gesture = static_cast<QNativeGestureEvent *>(event);
        if (gesture->gestureType() != Qt::ZoomNativeGesture)
            return false;
        m_view.span().zoom(1 + gesture->value(), m_view.plot().xAt(gesture->position().x()));
        return true;
    }
    case QEvent::Gesture: {
        auto *gestures = static_cast<QGestureEvent *>(event);
        const auto *pinch = static_cast<QPinchGesture *>(gestures->gesture(Qt::PinchGesture));
        if (!pinch || pinch->scaleFactor() <= 0)
            return false;
        const QPointF centre = m_view.viewport()->mapFromGlobal(pinch->hotSpot());
        m_view.span().zoom(pinch->scaleFactor(), m_view.plot().xAt(centre.x()));
        gestures->accept();
        return true;
    }
    default:
        return false;
    }
}

bool ChartGestures::press(const QMouseEvent &event)
{
    const bool isLeft = event.button() == Qt::LeftButton;
    if (event.button() == Qt::MiddleButton || (isLeft && event.modifiers() == Qt::ShiftModifier)) {
        m_pannedX = event.position().x();
        return true;
    }
    if (!isLeft || event.modifiers() != Qt::ControlModifier || !m_view.plot().rect.contains(event.position()))
        return false;
    m_boxFrom = event.position().toPoint();
    m_box->setGeometry(QRect(*m_boxFrom, QSize()));
    m_box->show();
    return true;
}

bool ChartGestures::move(const QMouseEvent &event)
{
    if (m_boxFrom) {
        m_box->setGeometry(QRect(*m_boxFrom, event.position().toPoint()).normalized());
        return true;
    }
    if (!m_pannedX)
        return false;
    const double x = event.position().x();
    m_view.span().pan((*m_pannedX - x) / std::max(1.0, m_view.plot().rect.width()));
    m_pannedX = x;
    return true;
}

bool ChartGestures::release(const QMouseEvent &event)
{
    if (m_pannedX) {
        m_pannedX.reset();
        return true;
    }
    if (!m_boxFrom)
        return false;
    const QRectF box = QRectF(*m_boxFrom, event.position()).normalized();
    m_boxFrom.reset();
    m_box->hide();
    const ChartPlot plot = m_view.plot();
    if (box.width() < QApplication::startDragDistance() || box.height() < QApplication::startDragDistance())
        return true;
    m_view.showValues(ValueRange{plot.valueAt(box.bottom()), plot.valueAt(box.top())});
    m_view.span().show(plot.xAt(box.left()), plot.xAt(box.right()));
    return true;
}

void ChartGestures::turnWheel(const QWheelEvent &event)
{
    constexpr double notch = 120, zoomStep = 1.25, panStep = 0.1;
    const QPoint turned = event.angleDelta();
    const bool isSideways = std::abs(turned.x()) > std::abs(turned.y());
    const double factor = std::pow(zoomStep, turned.y() / notch);
    const ChartPlot plot = m_view.plot();
    if (isSideways || event.modifiers().testFlag(Qt::ShiftModifier)) {
        m_view.span().pan(-panStep * (isSideways ? turned.x() : turned.y()) / notch);
    } else if (event.position().x() < plot.rect.left()) {
        const double about = plot.valueAt(event.position().y());
        m_view.showValues(ValueRange{about - (about - plot.values.low) / factor,
                                     about + (plot.values.high - about) / factor});
    } else {
        m_view.span().zoom(factor, plot.xAt(event.position().x()));
    }
}

} // namespace odo
