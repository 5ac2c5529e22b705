// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/curve_columns.h"

#include <algorithm>

namespace odo {

namespace {

bool isLeftOf(const BandPoint &point, double x)
{
    return point.x < x;
}

bool isBeyond(double x, const BandPoint &point)
{
    return x < point.x;
}

/// A column that covers both, which are of the same index.
void unite(CurveColumn &column, const CurveColumn &other)
{
    column.low = std::min(column.low, other.low);
    column.high = std::max(column.high, other.high);
    column.bandLow = std::min(column.bandLow, other.bandLow);
    column.bandHigh = std::max(column.bandHigh, other.bandHigh);
}

} // namespace

BandPoint::BandPoint(double place, const CurveValue &curveValue)
    : x(place), value(float(curveValue.value)), reach(float(coverage95 * curveValue.sigma))
{
}

CurveValue BandPoint::curveValue() const
{
    return {double(value), double(reach) / coverage95};
}

std::vector<CurveRun> curveRuns(const std::vector<std::optional<CurveValue>> &values,
                                const std::vector<double> &places)
{
    std::vector<CurveRun> runs;
    const auto exists = [](const std::optional<CurveValue> &value) { return value.has_value(); };
    for (auto begin = std::find_if(values.begin(), values.end(), exists); begin != values.end();) {
        const auto end = std::find_if_not(begin, values.end(), exists);
        CurveRun &run = runs.emplace_back(CurveRun{static_cast<std::size_t>(begin - values.begin()), {}});
        run.points.reserve(static_cast<std::size_t>(end - begin));
        for (auto value = begin; value != end; ++value)
            run.points.emplace_back(places[static_cast<std::size_t>(value - values.begin())], **value);
        begin = std::find_if(end, values.end(), exists);
    }
    return runs;
}

std::span<const BandPoint> visiblePoints(std::span<const BandPoint> points, double low, double high)
{
    if (points.empty() || points.back().x < low || points.front().x > high)
        return {};
    const auto inside = std::lower_bound(points.begin(), points.end(), low, isLeftOf);
    const auto beyond = std::upper_bound(inside, points.end(), high, isBeyond);
    return {inside == points.begin() ? inside : inside - 1, beyond == points.end() ? beyond : beyond + 1};
}

std::size_t visibleCount(std::span<const CurveRun> runs, double low, double high)
{
    std::size_t count = 0;
    for (const CurveRun &run : runs)
        count += visiblePoints(run.points, low, high).size();
    return count;
}

std::vector<CurveColumn> curveColumns(std::span<const CurveRun> runs, double low, double high, int count,
                                      ColumnReach reach)
{
    std::vector<CurveColumn> columns;
    if (count <= 0 || !(high > low))
        return columns;
    columns.reserve(static_cast<std::size_t>(count));
    const double step = (high - low) / count;
    for (const CurveRun &run : runs) {
        const std::span<const BandPoint> visible = visiblePoints(run.points, low, high);
        auto point = visible.begin();
        const auto end = std::upper_bound(visible.begin(), visible.end(), high, isBeyond);
        while (point != end && point->x < low)
            ++point;
        bool isJoined = false;
        while (point != end) {
            const int index = std::min(count - 1, static_cast<int>((point->x - low) / step));
            // The last column takes what rounding leaves over.
            const double edge = index + 1 < count ? low + (index + 1) * step : high + step;
            CurveColumn column{index, isJoined, point->value, point->value, point->low(), point->high()};
            if (reach == ColumnReach::Line && point != visible.begin())
                column.low = column.high = double((point - 1)->value);
            do {
                const double value = double(point->value), from = point->low(), to = point->high();
                column.low = value < column.low ? value : column.low;
                column.high = value > column.high ? value : column.high;
                column.bandLow = from < column.bandLow ? from : column.bandLow;
                column.bandHigh = to > column.bandHigh ? to : column.bandHigh;
                ++point;
            } while (point != end && point->x < edge);
            if (!columns.empty() && columns.back().index >= index)
                unite(columns.back(), column);
            else
                columns.push_back(column);
            isJoined = reach == ColumnReach::Line;
        }
    }
    return columns;
}

} // namespace odo
