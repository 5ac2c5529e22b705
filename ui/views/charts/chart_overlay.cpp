// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_overlay.h"

#include "ui/views/charts/chart_image.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/theme.h"

#include <QAbstractScrollArea>
#include <QFontMetricsF>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace odo {

void drawChartCursor(QPainter &painter, const ChartPlot &plot, double x, const QPalette &palette)
{
    const double screenX = plot.at(x, 0).x();
    painter.setPen(QPen(ThemeColours::of(palette).text, 1.4, Qt::DotLine));
    painter.drawLine(QPointF(screenX, plot.rect.top()), QPointF(screenX, plot.rect.bottom()));
}

void drawChartRange(QPainter &painter, const ChartPlot &plot, double from, double to, const QPalette &palette)
{
    const double left = plot.at(from, 0).x(), right = plot.at(to, 0).x();
    const QColor accent = ThemeColours::of(palette).accent;
    QColor haze = accent;
    haze.setAlpha(34);
    painter.fillRect(
        QRectF(QPointF(left, plot.rect.top()), QPointF(right, plot.rect.bottom())).intersected(plot.rect),
        haze);
    painter.setPen(QPen(accent, 1));
    for (const double x : {left, right})
        if (x >= plot.rect.left() && x <= plot.rect.right())
            painter.drawLine(QPointF(x, plot.rect.top()), QPointF(x, plot.rect.bottom()));
}

void drawChartOutside(QPainter &painter, const ChartPlot &plot, double from, double to,
                      const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    QColor veil = colours.border;
    veil.setAlpha(110);
    const double left = std::clamp(plot.at(from, 0).x(), plot.rect.left(), plot.rect.right()),
                 right = std::clamp(plot.at(to, 0).x(), plot.rect.left(), plot.rect.right());
    painter.fillRect(QRectF(plot.rect.topLeft(), QPointF(left, plot.rect.bottom())), veil);
    painter.fillRect(QRectF(QPointF(right, plot.rect.top()), plot.rect.bottomRight()), veil);
}

void drawChartFocus(QPainter &painter, const QWidget &plot)
{
    if (!plot.hasFocus() || ChartImage::isPaintedBy(painter, plot))
        return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ThemeColours::of(plot.palette()).accent, 1));
    painter.drawRect(plot.rect().adjusted(0, 0, -1, -1));
}

QRectF drawChartBubble(QPainter &painter, const ChartPlot &plot, const QPointF &value, double top,
                       const QString &fullText, const QColor &colour, const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const QFontMetricsF metrics(painter.font());
    // The value is at its end; a long name before it is shortened.
    const QString text = metrics.elidedText(fullText, Qt::ElideLeft, plot.rect.width() / 2);
    const QPointF at = plot.at(value.x(), value.y());
    const double height = metrics.height() + 6, width = metrics.horizontalAdvance(text) + 14;
    const bool fits = at.x() + 6 + width <= plot.rect.right();
    const QRectF bubble(fits ? at.x() + 6 : at.x() - 6 - width, top, width, height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.bubble);
    painter.drawRoundedRect(bubble, 3, 3);
    painter.setPen(colours.bubbleText);
    painter.drawText(bubble, Qt::AlignCenter, text);
    painter.setPen(QPen(colours.card, 1.5));
    painter.setBrush(colour);
    painter.drawEllipse(at, 4, 4);
    return bubble;
}

void drawCrosshair(QPainter &painter, const ChartPlot &plot, const QPointF &position, const QString &below,
                   const QString &left, const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const QFontMetricsF metrics(painter.font());
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(colours.muted, 1));
    painter.drawLine(QPointF(position.x(), plot.rect.top()), QPointF(position.x(), plot.rect.bottom()));
    painter.drawLine(QPointF(plot.rect.left(), position.y()), QPointF(plot.rect.right(), position.y()));
    painter.setRenderHint(QPainter::Antialiasing);
    const auto box = [&](const QRectF &rect, const QString &text) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours.bubble);
        painter.drawRoundedRect(rect, 3, 3);
        painter.setPen(colours.bubbleText);
        painter.drawText(rect, Qt::AlignCenter, text);
    };
    const double height = metrics.height() + 4;
    const double belowWidth = metrics.horizontalAdvance(below) + 12,
                 leftWidth = metrics.horizontalAdvance(left) + 10;
    box({position.x() - belowWidth / 2, plot.rect.bottom() + 3, belowWidth, height}, below);
    box({plot.rect.left() - 3 - leftWidth, position.y() - height / 2, leftWidth, height}, left);
}

ChartBubbles::ChartBubbles(QAbstractScrollArea &chart) : QObject(&chart), m_chart(chart)
{
    chart.installEventFilter(this); // keys
    chart.viewport()->installEventFilter(this);
}

void ChartBubbles::add(const QRectF &position, std::function<Explanation()> how)
{
    m_bubbles.append({position, std::move(how)});
}

QList<QRectF> ChartBubbles::positions() const
{
    QList<QRectF> positions;
    for (const Bubble &bubble : m_bubbles)
        positions << bubble.position;
    return positions;
}

const ChartBubbles::Bubble *ChartBubbles::at(const QPointF &point) const
{
    const auto found = std::ranges::find_if(
        m_bubbles, [&](const Bubble &bubble) { return bubble.position.contains(point); });
    return found == m_bubbles.end() ? nullptr : &*found;
}

void ChartBubbles::explain(const Bubble &bubble) const
{
    showExplanation(m_chart.window(), bubble.how());
}

bool ChartBubbles::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress: {
        const auto *press = static_cast<QMouseEvent *>(event);
        const Bubble *bubble = press->button() == Qt::LeftButton ? at(press->position()) : nullptr;
        if (!bubble)
            return false;
        m_isPressed = true;
        explain(*bubble);
        return true;
    }
    case QEvent::MouseMove:
        return m_isPressed;
    case QEvent::MouseButtonRelease:
        return std::exchange(m_isPressed, false);
    case QEvent::KeyPress: {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool isEnter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
        const bool isHow = key->key() == Qt::Key_F1 && key->modifiers() == Qt::ShiftModifier;
        if (m_bubbles.isEmpty() || !(isEnter || isHow))
            return false;
        explain(m_bubbles.first());
        return true;
    }
    case QEvent::ToolTip: {
        const auto *help = static_cast<QHelpEvent *>(event);
        if (!at(help->pos()))
            return false;
        QToolTip::showText(help->globalPos(), howComputedWords(), &m_chart);
        return true;
    }
    default:
        return QObject::eventFilter(watched, event);
    }
}

} // namespace odo
