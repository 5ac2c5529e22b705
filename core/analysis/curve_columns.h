// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"

#include <optional>
#include <span>
#include <vector>

namespace odo {

/// What of a curve a chart of some width can show: the points themselves, or, where there are more of them
/// than pixels, the extremes of each pixel column. Plain values; any thread.

/// A point of a curve with its 95 % band (1.96 σ), in single precision: a trial may have a million of them.
struct BandPoint
{
    BandPoint(double place, const CurveValue &curveValue);
    double x; ///< the place on the axis below
    float value, reach;
    double low() const { return double(value) - double(reach); }
    double high() const { return double(value) + double(reach); }
    CurveValue curveValue() const;
};

/// A stretch of a curve without gaps, sorted by x: one point a sample, from firstSample on.
struct CurveRun
{
    std::size_t firstSample = 0;
    std::vector<BandPoint> points;
    bool isLine() const { return points.size() >= 2; }
};

/// values: one a sample. places: where each sample lies on the axis below.
std::vector<CurveRun> curveRuns(const std::vector<std::optional<CurveValue>> &values,
                                const std::vector<double> &places);

/// The points from low to high, and the next one beyond either end, so that a line runs out of the plot.
/// Points must be sorted by x.
std::span<const BandPoint> visiblePoints(std::span<const BandPoint> points, double low, double high);

/// How many points of these runs visiblePoints gives all together.
std::size_t visibleCount(std::span<const CurveRun> runs, double low, double high);

/// What a curve does within one pixel column.
struct CurveColumn
{
    int index = 0;                    ///< of the column, from 0 at the left
    bool isJoined = false;            ///< the line goes on from the column before it in the list
    double low = 0, high = 0;         ///< its extremes
    double bandLow = 0, bandHigh = 0; ///< those of its band
};

/// Whether a column reaches to the last point before it, as a line does, or shows its own points alone.
enum class ColumnReach { Line, Points };

/// The extremes of each of `count` columns between low and high, so that no peak of a single sample is lost:
/// as fast to draw for an hour as for a second. Columns without points are left out. Runs must be in order.
std::vector<CurveColumn> curveColumns(std::span<const CurveRun> runs, double low, double high, int count,
                                      ColumnReach reach = ColumnReach::Line);

} // namespace odo
