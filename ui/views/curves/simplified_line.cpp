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

} // namespace odo
