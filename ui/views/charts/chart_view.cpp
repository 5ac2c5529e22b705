// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_view.h"

#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/chart_overlay.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QDateTime>
#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QObject>
#include <QPainter>
#include <QPinchGesture>
#include <QPointF>
#include <QRubberBand>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <optional>

class QMouseEvent;
class QRubberBand;
class QWheelEvent;

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

ChartView::ChartView(AxisSpan &span, const ChartAxes &axes, QWidget *parent)
    : QChartView(new Chart(axes), parent), m_span(span), m_chart(static_cast<Chart *>(chart()))
{
    setFrameShape(NoFrame);
    setInteractive(false);
    viewport()->setFocusPolicy(Qt::NoFocus); // it would be a second stop of the Tab key
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(0, 0);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    viewport()->setMouseTracking(true);
    viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
    new ChartGestures(*this);
    m_chart->setStyle(palette(), font());
    connect(&m_span, &AxisSpan::spanChanged, this, &ChartView::refresh);
    refresh();
}

ChartView::~ChartView() = default;

void ChartView::forget()
{
    m_still.forget();
    viewport()->update();
}

void ChartView::refresh()
{
    m_chart->show(m_span.low(), m_span.high(), m_values);
    forget();
}

void ChartView::setAxes(const ChartAxes &axes)
{
    m_chart->setAxes(axes);
    m_values.reset();
}

void ChartView::setContent(ChartContentPtr content, std::vector<ChartStretch> stretches)
{
    m_chart->setContent(std::move(content), std::move(stretches));
    refresh();
}

void ChartView::setOverlay(std::vector<ChartCurve> curves)
{
    if (m_chart->setOverlay(std::move(curves)))
        forget();
}

void ChartView::showValues(std::optional<ValueRange> values)
{
    if (values && !(values->high > values->low))
        return;
    m_values = values;
    refresh();
}

void ChartView::showAll()
{
    m_values.reset();
    m_span.showAll();
    refresh();
}

void ChartView::setGroupShown(int group, bool isShown)
{
    m_chart->setGroupShown(group, isShown);
    forget();
}

void ChartView::showAllGroups()
{
    m_chart->showAllGroups();
    forget();
}

void ChartView::paintStill(QPainter &painter)
{
    m_chart->prepare();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, !m_chart->isCoarse());
    scene()->render(&painter, QRectF(viewport()->rect()), QRectF(viewport()->rect()), Qt::IgnoreAspectRatio);
    painter.restore();
}

void ChartView::paintImage(QPainter &painter)
{
    painter.fillRect(viewport()->rect(), ThemeColours::of(palette()).card);
    paintStill(painter);
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    paintOver(painter);
}

void ChartView::paintCrosshair(QPainter &painter) const
{
    const ChartPlot plot = this->plot();
    const ChartAxes &axes = m_chart->axesShown();
    const double x = plot.xAt(m_mouse->x()), value = plot.valueAt(m_mouse->y());
    // As many digits as a pixel is worth.
    const auto digits = [](double perPixel) {
        return std::clamp(-int(std::floor(std::log10(std::max(1e-9, perPixel)))), 0, 6);
    };
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double perSi = axes.below.perSi;
    const QString below =
        axes.style == ChartStyle::Dates
            ? locale.toString(QDateTime::fromMSecsSinceEpoch(qint64(x)).date(), QLocale::ShortFormat)
            : locale.toString(perSi * x, 'f', digits(perSi * (plot.high - plot.low) / plot.rect.width())) +
                  u' ' + axes.below.name;
    drawCrosshair(
        painter, plot, *m_mouse, below,
        locale.toString(value, 'f', digits((plot.values.high - plot.values.low) / plot.rect.height())),
        palette());
}

void ChartView::paintEvent(QPaintEvent *)
{
    QPainter painter(viewport());
    m_still.paint(painter, *viewport(), ThemeColours::of(palette()).card,
                  [this](QPainter &still) { paintStill(still); });
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_mouse && m_chart->hasContent() && m_chart->axesShown().style != ChartStyle::Bars)
        paintCrosshair(painter);
    paintOver(painter);
    drawChartFocus(painter, *this);
}

void ChartView::resizeEvent(QResizeEvent *event)
{
    QChartView::resizeEvent(event);
    setMinimumSize(0, 0);
    m_chart->setSize(viewport()->size());
    refresh();
}

void ChartView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        m_chart->setStyle(palette(), font());
        refresh();
    }
    QChartView::changeEvent(event);
}

bool ChartView::viewportEvent(QEvent *event)
{
    switch (event->type()) {
    case QEvent::ToolTip: {
        const auto *help = static_cast<QHelpEvent *>(event);
        showToolTip(*help, plot().rect.contains(help->pos()) ? wordsAt(help->pos()) : QString(), this);
        return true;
    }
    case QEvent::Leave:
        m_mouse.reset();
        viewport()->update();
        break;
    default:
        break;
    }
    return QChartView::viewportEvent(event);
}

QString ChartView::wordsAt(const QPoint &) const
{
    return {};
}

void ChartView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_pressedX = event->position().x();
    m_isDragged = false;
    goTo(plot().xAt(*m_pressedX));
}

void ChartView::mouseMoveEvent(QMouseEvent *event)
{
    const double x = event->position().x();
    m_mouse.reset();
    if (event->buttons() == Qt::NoButton && plot().rect.contains(event->position()))
        m_mouse = event->position();
    viewport()->update();
    if (!event->buttons().testFlag(Qt::LeftButton) || !m_pressedX)
        return;
    m_isDragged = m_isDragged || std::abs(x - *m_pressedX) >= QApplication::startDragDistance();
    if (m_isDragged)
        dragTo(plot().xAt(*m_pressedX), plot().xAt(x));
}

void ChartView::mouseReleaseEvent(QMouseEvent *)
{
    m_pressedX.reset();
}

void ChartView::keyPressEvent(QKeyEvent *event)
{
    event->ignore(); // nothing is scrolled here: the keys belong to the page
}

void ChartView::focusInEvent(QFocusEvent *event)
{
    QChartView::focusInEvent(event);
    viewport()->update();
}

void ChartView::focusOutEvent(QFocusEvent *event)
{
    QChartView::focusOutEvent(event);
    viewport()->update();
}

} // namespace odo
