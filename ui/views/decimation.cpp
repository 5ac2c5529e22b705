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

} // namespace odo
