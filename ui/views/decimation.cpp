// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/decimation.h"

#include <algorithm>
#include <array>

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
    if (columns <= 0 || right <= left || points.size() <= keptPerColumn * columns)
        return points;
    QList<QPointF> kept;
    kept.reserve(keptPerColumn * columns);
    const auto columnOf = [&](const QPointF &point) {
        return static_cast<int>(std::clamp((point.x() - left) / (right - left), 0.0, 1.0) * columns);
    };
    qsizetype first = 0;
    while (first < points.size()) {
        const int column = columnOf(points[first]);
        qsizetype end = first + 1;
        while (end < points.size() && columnOf(points[end]) == column)
            ++end;
        appendColumn(points, first, end, kept);
        first = end;
    }
    return kept;
}

} // namespace odo
