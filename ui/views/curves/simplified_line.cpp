// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/curves/simplified_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace odo {

bool LineSimplifier::Cone::takes(const QPointF &point, double tolerance)
{
    const QPointF apart = point - m_anchor;
    const double distance = std::hypot(apart.x(), apart.y());
    if (distance + tolerance < m_farthest) // it goes back: the turning point must stay
        return false;
    if (distance <= tolerance)
        return !m_isOpen; // within reach of any line from here
    const double angle = std::atan2(apart.y(), apart.x());
    const double reach = std::asin(std::min(1.0, tolerance / distance));
    if (!m_isOpen) {
        m_isOpen = true;
        m_middle = angle;
        m_low = -reach;
        m_high = reach;
    } else {
        const double turned = std::remainder(angle - m_middle, 2 * std::numbers::pi);
        if (turned < m_low || turned > m_high)
            return false;
        m_low = std::max(m_low, turned - reach);
        m_high = std::min(m_high, turned + reach);
    }
    m_farthest = std::max(m_farthest, distance);
    return true;
}

void LineSimplifier::add(const QPointF &point)
{
    if (m_kept.isEmpty()) {
        m_kept << point;
        m_cone = Cone(point);
    } else if (m_isLine = true; !m_cone.takes(point, m_tolerance)) {
        m_kept << m_last;
        m_cone = Cone(m_last);
        m_cone.takes(point, m_tolerance);
    }
    m_last = point;
}

QPolygonF LineSimplifier::take()
{
    if (m_isLine)
        m_kept << m_last;
    m_isLine = false;
    return std::exchange(m_kept, {});
}

QPolygonF simplified(const QPolygonF &line, double tolerance)
{
    LineSimplifier simplifier(tolerance);
    for (const QPointF &point : line)
        simplifier.add(point);
    return simplifier.take();
}

SeenLine::SeenLine(double tolerance, const QRectF &seen, Take take)
    : m_piece(tolerance), m_seen(seen), m_take(std::move(take))
{
}

/// It may be: not if all of it is beyond one edge.
bool SeenLine::isSeen(const QPointF &from, const QPointF &to) const
{
    return m_seen.isEmpty() ||
           (std::max(from.x(), to.x()) >= m_seen.left() && std::min(from.x(), to.x()) <= m_seen.right() &&
            std::max(from.y(), to.y()) >= m_seen.top() && std::min(from.y(), to.y()) <= m_seen.bottom());
}

void SeenLine::add(const QPointF &point)
{
    const std::optional<QPointF> from = std::exchange(m_last, point);
    if (!from)
        return;
    if (!isSeen(*from, point))
        return cut();
    if (m_piece.isEmpty())
        m_piece.add(*from);
    m_piece.add(point);
}

void SeenLine::cut()
{
    if (!m_piece.isEmpty())
        m_take(m_piece.take());
}

void SeenLine::end()
{
    cut();
    m_last.reset();
}

} // namespace odo
