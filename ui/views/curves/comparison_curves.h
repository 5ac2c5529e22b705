// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/compare/trial_metrics.h"
#include "ui/models/comparison_scene.h"
#include "ui/views/curves/chart_content.h"

#include <QString>
#include <optional>
#include <vector>

namespace odo {

/// The curves of several runs over the distance along their common path, as values; any thread.

/// What is shown against the distance.
enum class Compared { Speed, TimeDifference };
/// "m/s" or as shown_units.h has it; "s".
QString comparedUnit(Compared what);
/// The distance below, that unit at the left.
ChartAxes comparedAxes(Compared what);

/// The curves of these runs with their 95 % bands, a group each, in the run's colour and dash. Speed: where
/// each run first came to each station. Time difference: how much later each run but the first is, grey where
/// that is within its uncertainty, with a line where neither is ahead. 0 is among the values.
ChartContentPtr comparedContent(const ComparisonScene &scene, Compared what,
                                const std::vector<std::size_t> &runs);
/// All runs.
ChartContentPtr comparedContent(const ComparisonScene &scene, Compared what);
/// The part of the path that the runs have in common, metres.
struct PathSpan
{
    double lowM = 0, highM = 1;
};
PathSpan comparedSpan(const ComparisonScene &scene);

/// The same at one position; nullopt where a run was not there.
std::optional<CurveValue> differenceAt(const ComparisonScene &scene, std::size_t run, double distanceM);
std::optional<CurveValue> comparedAt(const ComparisonScene &scene, Compared what, std::size_t run,
                                     double distanceM);

/// A team's runs through the term as a chart: a point each, the line of progress through them (dashed where
/// the spread explains it), and the band of the spread about it; days below, the name of the metric with its
/// unit at the left. The team must have a run. A value; any thread.
ChartDrawing trendDrawing(const TeamStanding &team);

} // namespace odo
