// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/simplified_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace odo {

namespace {

constexpr qsizetype keptPerColumn = 4;

void appendColumn(const QList<QPointF> &points, qsizetype first, qsizetype end, QList<QPointF> &kept)
{
    const auto lower = [&points](qsizetype a, qsizetype b) { return points[a].y() < points[b].y(); };
    qsizetype low = first, high = first;
    for (qsizetype i = first; i < end; ++i) {
        low = lower(i, low) ? i : low;
        high = lower(high, i) ? i : high;
    }
    std::array<qsizetype, keptPerColumn> chosen{first, low, high, end - 1};
    std::sort(chosen.begin(), chosen.end());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (i == 0 || chosen[i] != chosen[i - 1])
            kept.append(points[chosen[i]]);
    }
}

} // namespace

QList<QPointF> decimated(const QList<QPointF> &points, double left, double right, int columns)
{
    if (columns <= 0 || right <= left)
        return points;
    const auto isLeft = [](const QPointF &point, double x) { return point.x() < x; };
    const auto isRight = [](double x, const QPointF &point) { return x < point.x(); };
    const qsizetype inside = std::lower_bound(points.begin(), points.end(), left, isLeft) - points.begin();
    const qsizetype beyond = std::upper_bound(points.begin(), points.end(), right, isRight) - points.begin();
    const qsizetype begin = std::max<qsizetype>(0, inside - 1), last = std::min(points.size(), beyond + 1);
    if (last - begin <= keptPerColumn * columns)
        return begin == 0 && last == points.size() ? points : points.mid(begin, last - begin);
    QList<QPointF> kept;
    kept.reserve(keptPerColumn * (columns + 2));
    if (begin < inside)
        kept.append(points[begin]);
    qsizetype first = inside;
    for (int column = 1; first < beyond; ++column) {
        // The last column takes what rounding leaves over.
        const double edge = column < columns ? left + (right - left) * column / columns : right;
        qsizetype end = first;
        while (end < beyond && (points[end].x() < edge || column >= columns))
            ++end;
        if (end > first)
            appendColumn(points, first, end, kept);
        first = end;
    }
    if (beyond < last)
        kept.append(points[beyond]);
    return kept;
}

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
