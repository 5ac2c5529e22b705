// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_bubbles.h"

#include "ui/views/widgets/fact_list.h"

#include <QAbstractScrollArea>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <utility>

namespace odo {

ChartBubbles::ChartBubbles(QAbstractScrollArea &chart) : QObject(&chart), m_chart(chart)
{
    chart.installEventFilter(this); // keys
    chart.viewport()->installEventFilter(this);
}

void ChartBubbles::add(const QRectF &place, std::function<Explanation()> how)
{
    m_bubbles.append({place, std::move(how)});
}

QList<QRectF> ChartBubbles::places() const
{
    QList<QRectF> places;
    for (const Bubble &bubble : m_bubbles)
        places << bubble.place;
    return places;
}

const ChartBubbles::Bubble *ChartBubbles::at(const QPointF &point) const
{
    const auto found =
        std::ranges::find_if(m_bubbles, [&](const Bubble &bubble) { return bubble.place.contains(point); });
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
