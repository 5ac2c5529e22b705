// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/scoring.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace odo {

namespace {

constexpr std::size_t mostLines = 30;
constexpr double mostPoints = 1000;

double shareAt(const Criterion &criterion, double value)
{
    return std::clamp((value - criterion.noneAt) / (criterion.fullAt - criterion.noneAt), 0.0, 1.0);
}

CriterionScore scoreLine(const Criterion &criterion, const std::vector<Metric> &metrics)
{
    CriterionScore line{criterion, {}, 0, 0, 0};
    const auto metric = std::ranges::find(metrics, criterion.metric, &Metric::name);
    if (metric == metrics.end() || !std::isfinite(metric->value))
        return line;
    line.metric = *metric;
    line.share = shareAt(criterion, metric->value);
    line.points = criterion.points * line.share;
    const double sigma = metric->sigma.value_or(0);
    line.sigma = std::abs(criterion.points * (shareAt(criterion, metric->value + sigma) -
                                              shareAt(criterion, metric->value - sigma))) /
                 2;
    return line;
}

} // namespace

std::vector<Metric> scoringMetrics(const std::vector<Spike> &spikes, const std::vector<GatePassage> &passages)
{
    constexpr SampleFlags limits = flagBit(SampleFlag::SpeedLimit) | flagBit(SampleFlag::AccelerationLimit);
    const auto breaches =
        std::ranges::count_if(spikes, [](const Spike &spike) { return (spike.flags & limits) != 0; });
    std::set<std::string> gates;
    for (const GatePassage &passage : passages)
        gates.insert(passage.gate);
    return {{"spikes", "1", double(spikes.size()), {}},
            {"limit_breaches", "1", double(breaches), {}},
            {"gates_passed", "1", double(gates.size()), {}}};
}

Score scoreOf(const std::vector<Criterion> &criteria, const std::vector<Metric> &metrics)
{
    Score score;
    double variance = 0;
    for (const Criterion &criterion : criteria) {
        score.lines.push_back(scoreLine(criterion, metrics));
        score.points += score.lines.back().points;
        score.most += std::max(0.0, criterion.points);
        variance += score.lines.back().sigma * score.lines.back().sigma;
    }
    score.sigma = std::sqrt(variance);
    return score;
}

bool hasCourse(const Task &task)
{
    return !task.gates.empty() || !task.path.points.empty() || task.limits.maxSpeedMps ||
           task.limits.maxAccelMps2 || !task.zones.empty();
}

Result<void> checkScoring(const std::vector<Criterion> &criteria)
{
    if (criteria.size() > mostLines)
        return fail(ErrorCode::InvalidInput, ODO_TEXT("analysis.scoring", "scoring"),
                    ODO_TEXT("analysis.many_lines", "it has more than %1 lines")(mostLines),
                    ODO_TEXT("analysis.keep_what_matters", "keep those that matter"));
    for (std::size_t i = 0; i < criteria.size(); ++i) {
        const Criterion &line = criteria[i];
        const auto refuse = [i](Message why, Message advice) {
            return fail(ErrorCode::InvalidInput,
                        ODO_TEXT("analysis.line_of_scoring", "line %1 of the scoring")(i + 1), std::move(why),
                        std::move(advice));
        };
        if (line.metric.empty())
            return refuse(ODO_TEXT("analysis.no_figure", "it names no metric"),
                          ODO_TEXT("analysis.choose_figure", "choose a metric to score"));
        if (!std::isfinite(line.fullAt) || !std::isfinite(line.noneAt) || !std::isfinite(line.points))
            return refuse(ODO_TEXT("analysis.number_is_none", "one of its values is not a number"),
                          ODO_TEXT("analysis.give_three_numbers", "enter three numbers"));
        if (line.fullAt == line.noneAt)
            return refuse(ODO_TEXT("analysis.same_values", "full points and no points have the same value"),
                          ODO_TEXT("analysis.give_two_values",
                                   "enter two different values; the points rise between them"));
        if (line.points == 0 || std::abs(line.points) > mostPoints)
            return refuse(ODO_TEXT("analysis.points_out_of_range", "its points are 0 or beyond ±1000"),
                          ODO_TEXT("analysis.give_points",
                                   "enter points from 1 to 1000; use a negative number for a penalty"));
    }
    return {};
}

} // namespace odo
