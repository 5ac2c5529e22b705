// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/simplified_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

/// The directions in which a straight line may go from an anchor so that it passes all points seen since.
class Cone
{
public:
    Cone(const QPointF &anchor, double tolerance) : m_anchor(anchor), m_tolerance(tolerance) {}

    /// False, and unchanged, where no line to this point keeps all points before it.
    bool takes(const QPointF &point)
    {
        const QPointF apart = point - m_anchor;
        const double distance = std::hypot(apart.x(), apart.y());
        if (distance + m_tolerance < m_farthest) // it goes back: the turning point must stay
            return false;
        if (distance <= m_tolerance)
            return !m_isOpen; // within reach of any line from here
        const double angle = std::atan2(apart.y(), apart.x());
        const double reach = std::asin(std::min(1.0, m_tolerance / distance));
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

private:
    QPointF m_anchor;
    double m_tolerance, m_farthest = 0;
    bool m_isOpen = false;                      ///< a first direction is known
    double m_middle = 0, m_low = 0, m_high = 0; ///< radians; the bounds from the middle
};

} // namespace

QPolygonF simplified(const QPolygonF &line, double tolerance)
{
    if (line.size() < 3)
        return line;
    QPolygonF kept;
    kept << line.front();
    Cone cone(line.front(), tolerance);
    for (qsizetype i = 1; i < line.size(); ++i) {
        if (cone.takes(line[i]))
            continue;
        kept << line[i - 1];
        cone = Cone(line[i - 1], tolerance);
        cone.takes(line[i]);
    }
    kept << line.back();
    return kept;
}

} // namespace odo
