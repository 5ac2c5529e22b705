// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/result_statistics.h"

#include "core/analysis/metric_table.h"
#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace odo {

namespace {

std::string groupOf(const TrialTableRow &row, const ResultGrouping &grouping)
{
    switch (grouping.by) {
    case ResultGrouping::By::Nothing:
        break;
    case ResultGrouping::By::Team:
        return row.trial.teamName;
    case ResultGrouping::By::Class:
        return row.trial.className;
    case ResultGrouping::By::Task:
        return row.trial.task;
    case ResultGrouping::By::Robot:
        return row.robot;
    case ResultGrouping::By::Variable:
        if (const auto found = row.trial.variables.find(grouping.variable);
            found != row.trial.variables.end())
            return found->second;
    }
    return {};
}

/// values: at least one; sorted otherwise afterwards.
void fill(ResultStatistics &statistics, std::vector<double> &values, const std::optional<double> &onlySigma)
{
    const auto count = static_cast<double>(values.size());
    statistics.count = values.size();
    statistics.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    const auto [least, most] = std::ranges::minmax_element(values);
    statistics.least = *least;
    statistics.most = *most;
    if (values.size() > 1) {
        double squares = 0;
        for (const double value : values)
            squares += (value - statistics.mean) * (value - statistics.mean);
        statistics.deviation = std::sqrt(squares / (count - 1));
        statistics.meanSigma = *statistics.deviation / std::sqrt(count);
        if (statistics.mean != 0)
            statistics.variation = *statistics.deviation / std::abs(statistics.mean);
    } else {
        statistics.meanSigma = onlySigma;
    }
    statistics.median = medianOf(values);
}

} // namespace

bool isUsed(const ResultTable &table, std::size_t row, std::size_t column)
{
    const TrialTableRow &run = table.rows[row];
    const std::optional<Metric> &metric = run.metrics[column];
    if (!metric || !std::isfinite(metric->value) || metric->isAtLeast)
        return false;
    if (run.verdict && run.verdict->level() == CheckLevel::Bad)
        return false;
    if (!run.isMeasuredOtherwise)
        return true;
    // the score, which the table of metrics does not have, belongs to the task as well
    const MetricKind *kind = metricKind(metric->name);
    return kind && !kind->isOfTask();
}

std::vector<ResultStatistics> resultStatistics(const ResultTable &table, std::span<const std::size_t> rows,
                                               std::span<const std::size_t> columns,
                                               const ResultGrouping &grouping)
{
    std::map<std::string, std::vector<std::size_t>> groups;
    for (const std::size_t row : rows)
        groups[groupOf(table.rows[row], grouping)].push_back(row);
    std::vector<ResultStatistics> all;
    std::vector<double> values;
    for (const std::size_t column : columns)
        for (const auto &[name, members] : groups) {
            values.clear();
            std::optional<double> sigma;
            for (const std::size_t row : members)
                if (isUsed(table, row, column)) {
                    values.push_back(table.rows[row].metrics[column]->value);
                    sigma = table.rows[row].metrics[column]->sigma;
                }
            if (values.empty())
                continue;
            ResultStatistics &statistics = all.emplace_back();
            statistics.group = name;
            statistics.column = column;
            fill(statistics, values, sigma);
        }
    return all;
}

} // namespace odo
