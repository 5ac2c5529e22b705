// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/term_progress.h"

#include "core/analysis/metric_table.h"
#include "core/analysis/quantity_curve.h"
#include "core/base/coverage.h"
#include "core/base/percentile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace odo {

namespace {

double meanOf(const std::vector<double> &values)
{
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

double squaresAbout(double mean, const std::vector<double> &values)
{
    double sum = 0;
    for (const double value : values)
        sum += (value - mean) * (value - mean);
    return sum;
}

} // namespace

TermProgress termProgress(const std::vector<TermValue> &metrics, bool isLessBetter)
{
    std::vector<double> days, values;
    for (const TermValue &termValue : metrics) {
        days.push_back(termValue.day);
        values.push_back(termValue.value);
    }
    TermProgress progress;
    progress.count = static_cast<int>(metrics.size());
    progress.best = isLessBetter ? std::ranges::min(values) : std::ranges::max(values);
    progress.median = median(values);
    const double day = meanOf(days), value = meanOf(values);
    progress.atStart = value;
    if (metrics.size() < 2)
        return progress;
    const double daySquares = squaresAbout(day, days);
    if (metrics.size() < 3 || daySquares <= 0) {
        progress.spread = std::sqrt(squaresAbout(value, values) / (progress.count - 1));
        return progress;
    }
    double slope = 0;
    for (const TermValue &termValue : metrics)
        slope += (termValue.day - day) * (termValue.value - value) / daySquares;
    double left = 0;
    for (const TermValue &termValue : metrics) {
        const double off = termValue.value - value - slope * (termValue.day - day);
        left += off * off;
    }
    const int degrees = progress.count - 2;
    progress.spread = std::sqrt(left / degrees);
    const auto [first, last] = std::ranges::minmax(days);
    progress.atStart = value + slope * (first - day);
    progress.change =
        UncertainValue{slope * (last - first), *progress.spread / std::sqrt(daySquares) * (last - first)};
    progress.isBeyondSpread = std::abs(progress.change->value) > studentT95(degrees) * progress.change->sigma;
    return progress;
}

void rankTeams(std::vector<TeamStatistics> &teams, bool isLessBetter)
{
    double squares = 0;
    std::size_t degrees = 0;
    for (const TeamStatistics &team : teams) {
        if (team.values.empty())
            continue;
        squares += squaresAbout(meanOf(team.values), team.values);
        degrees += team.values.size() - 1;
    }
    const double spread = degrees > 0 ? std::sqrt(squares / static_cast<double>(degrees)) : 0;
    for (TeamStatistics &team : teams) {
        const auto count = static_cast<double>(team.values.size());
        team.median = team.values.empty() ? 0 : median(team.values);
        team.sigma = team.values.empty() ? 0
                                         : std::max(spread, team.runSigma) / std::sqrt(count) *
                                               (count > 2 ? std::sqrt(std::numbers::pi / 2) : 1);
    }
    for (TeamStatistics &team : teams) {
        const auto isAhead = [&](const TeamStatistics &other) {
            const double by = (isLessBetter ? 1 : -1) * (team.median - other.median);
            return !other.values.empty() && by > coverage95 * std::hypot(team.sigma, other.sigma);
        };
        team.rank = team.values.empty() ? 0 : 1 + static_cast<int>(std::ranges::count_if(teams, isAhead));
    }
}

bool isLessBetter(const std::string &metric)
{
    const MetricKind *kind = metricKind(metric);
    return kind && kind->better == MetricKind::Better::Less;
}

} // namespace odo
