// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/picture_bars.h"

#include "ui/views/theme.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace odo {
namespace {

constexpr double left = 48, right = 10, top = 12, bottom = 22;
constexpr double grabPx = 7, keyStep = 1.05;
constexpr double looseFactor = 1.5; // the threshold begins so far above the worst picture

QString pixels(double px) { return QLocale().toString(px, 'f', px < 1 ? 2 : 1); }

} // namespace

PictureBars::PictureBars(QWidget *parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Error of each picture, with a threshold"));
}

void PictureBars::setBars(const QStringList &names, std::vector<double> errorsPx)
{
    m_names = names;
    m_errors = std::move(errorsPx);
    if (m_threshold <= 0 && !m_errors.empty())
        m_threshold = looseFactor * *std::max_element(m_errors.begin(), m_errors.end());
    m_current = std::min(m_current, int(m_errors.size()) - 1);
    update();
}

void PictureBars::setCurrent(int index)
{
    if (index == m_current || index < 0 || index >= int(m_errors.size()))
        return;
    m_current = index;
    update();
    Q_EMIT currentChanged(index);
}

QRectF PictureBars::plotRect() const { return QRectF(rect()).adjusted(left, top, -right, -bottom); }

double PictureBars::topPx() const
{
    const double worst = m_errors.empty() ? 1 : *std::max_element(m_errors.begin(), m_errors.end());
    return std::max({1.15 * worst, 1.1 * m_threshold, 0.05});
}

double PictureBars::yOf(double errorPx) const
{
    const QRectF plot = plotRect();
    return plot.bottom() - plot.height() * std::min(1.0, errorPx / topPx());
}

int PictureBars::barAt(const QPointF &place) const
{
    const QRectF plot = plotRect();
    if (m_errors.empty() || !plot.contains(place))
        return -1;
    return std::min(int((place.x() - plot.x()) * double(m_errors.size()) / plot.width()), int(m_errors.size()) - 1);
}

void PictureBars::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.card);
    const QRectF plot = plotRect();
    painter.setPen(colours.grid);
    for (const double part : {0.0, 0.5, 1.0}) {
        const double y = plot.bottom() - part * plot.height();
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(colours.muted);
        painter.drawText(QRectF(0, y - 10, left - 6, 20), Qt::AlignRight | Qt::AlignVCenter, pixels(part * topPx()));
    }
    const double step = m_errors.empty() ? 0 : plot.width() / double(m_errors.size());
    const double gap = std::min(4.0, 0.2 * step);
    for (std::size_t i = 0; i < m_errors.size(); ++i) {
        const QRectF bar(plot.x() + double(i) * step + gap / 2, yOf(m_errors[i]), step - gap, plot.bottom() - yOf(m_errors[i]));
        const bool counts = m_errors[i] <= m_threshold;
        painter.fillRect(bar, counts ? QBrush(colours.accent) : QBrush(colours.spike, Qt::BDiagPattern));
        painter.setPen(int(i) == m_current ? QPen(colours.text, 2) : QPen(counts ? colours.accent : colours.spike, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(bar);
    }
    const double y = yOf(m_threshold);
    painter.setPen(QPen(colours.text, 1.5, Qt::DashLine));
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.setBrush(colours.text);
    painter.drawEllipse(QPointF(plot.right(), y), 4, 4);
    painter.setPen(colours.text);
    painter.drawText(QRectF(plot.left(), height() - bottom, plot.width(), bottom), Qt::AlignCenter,
                     m_current >= 0 ? tr("%1: %2 px").arg(m_names.value(m_current), pixels(m_errors[std::size_t(m_current)]))
                                    : tr("pictures; above %1 px they do not count").arg(pixels(m_threshold)));
    if (hasFocus()) {
        painter.setPen(colours.accent);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void PictureBars::setThreshold(double px)
{
    // Three pictures at least must stay: fewer tell nothing.
    std::vector<double> sorted = m_errors;
    std::sort(sorted.begin(), sorted.end());
    m_threshold = std::max(px, sorted.size() >= 3 ? sorted[2] : px);
    update();
}

void PictureBars::mousePressEvent(QMouseEvent *event)
{
    if (std::abs(event->position().y() - yOf(m_threshold)) <= grabPx)
        m_dragging = true;
    else
        setCurrent(barAt(event->position()));
}

void PictureBars::mouseMoveEvent(QMouseEvent *event)
{
    const bool near = m_dragging || std::abs(event->position().y() - yOf(m_threshold)) <= grabPx;
    setCursor(near ? Qt::SizeVerCursor : Qt::ArrowCursor);
    if (!m_dragging)
        return;
    const QRectF plot = plotRect();
    setThreshold(topPx() * (plot.bottom() - event->position().y()) / plot.height());
}

void PictureBars::mouseReleaseEvent(QMouseEvent *)
{
    if (std::exchange(m_dragging, false))
        Q_EMIT thresholdChanged(m_threshold);
}

void PictureBars::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
        setThreshold(event->key() == Qt::Key_Up ? m_threshold * keyStep : m_threshold / keyStep);
        Q_EMIT thresholdChanged(m_threshold);
        break;
    case Qt::Key_Left:
        setCurrent(std::max(0, m_current - 1));
        break;
    case Qt::Key_Right:
        setCurrent(m_current + 1);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace odo
