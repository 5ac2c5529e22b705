// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trials/trial_table_reading.h"

#include "core/analysis/metric_table.h"
#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/stored_verdicts.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace odo {

namespace {

/// The choice with the names as the project has them.
Result<TrialTableChoice> checked(Project &project, TrialTableChoice choice)
{
    if (!choice.className.empty())
        choice.className = ODO_TRY(project.classes().find(choice.className)).name;
    if (!choice.task.empty())
        choice.task = ODO_TRY(project.tasks().find(choice.task)).name;
    if (!choice.team.empty())
        choice.team = ODO_TRY(project.teams().find(choice.team)).name;
    auto known = ODO_TRY(project.analyses().metricNames());
    known.emplace_back(scoreMetric);
    for (const std::string &metric : choice.metrics)
        if (std::ranges::find(known, metric) == known.end())
            return fail(ErrorCode::NotFound, ODO_TEXT("workflow.metric_named", "metric '%1'")(metric),
                        ODO_TEXT("workflow.no_such_metric", "no trial of the project has it"),
                        ODO_TEXT("workflow.choose_metric", "choose from %1")(
                            listed(known, MessageArgument::Kind::Label, MessageArgument::Joint::Comma)));
    return choice;
}

bool isChosen(const TrialRecord &trial, const TrialTableChoice &choice)
{
    return countsIn(trial, choice.className, choice.task) &&
           (choice.team.empty() || trial.teamName == choice.team);
}

/// What is read once for all trials.
struct Grounds
{
    std::map<RecordId, TrialVerdict> verdicts;
    std::map<RecordId, std::vector<std::string>> lowerBounds; ///< by analysis, where they are not stored yet
    std::set<RecordId> otherwise;
    std::map<std::pair<RecordId, RecordId>, Metric> scores; ///< by trial and robot
};

Result<Grounds> readGrounds(Project &project, const std::vector<TrialRecord> &trials)
{
    Grounds grounds;
    grounds.verdicts = ODO_TRY(project.verdicts().all(Instant::min(), Instant::max()));
    auto missing = ODO_TRY(project.verdicts().missing(Instant::min(), Instant::max()));
    std::erase_if(missing, [&](RecordId trial) {
        return std::ranges::find(trials, trial, &TrialRecord::id) == trials.end();
    });
    auto computed = ODO_TRY(computeVerdicts(project, missing));
    for (StoredVerdict &one : computed) {
        grounds.verdicts[one.trial] = std::move(one.verdict);
        grounds.lowerBounds.merge(one.lowerBounds);
    }
    const auto otherwise = ODO_TRY(project.analyses().trialsMeasuredOtherwise());
    for (const OtherwiseMeasured &one : otherwise)
        grounds.otherwise.insert(one.trial);
    const auto scores = ODO_TRY(scoreMetrics(project, Instant::min(), Instant::max()));
    for (const TrialMetric &score : scores)
        grounds.scores.emplace(std::pair(score.trial, score.robot), score.metric);
    return grounds;
}

/// A row before it is known which columns there are.
struct Run
{
    TrialTableRow row;
    std::vector<Metric> metrics;
};

Result<std::vector<Run>> runsOf(Project &project, const TrialRecord &trial, const Grounds &grounds)
{
    TrialTableRow row{trial, {}, {}, grounds.otherwise.contains(trial.id), {}};
    if (const auto verdict = grounds.verdicts.find(trial.id); verdict != grounds.verdicts.end())
        row.verdict = verdict->second;
    auto analyses = ODO_TRY(project.analyses().currentMetrics(trial.id));
    if (analyses.empty())
        return std::vector<Run>{{row, {}}};
    std::vector<Run> runs;
    for (AnalysisRecord &analysis : analyses) {
        row.robot = analysis.robotName;
        runs.push_back({row, std::move(analysis.profile.metrics)});
        std::vector<Metric> &metrics = runs.back().metrics;
        if (const auto bounds = grounds.lowerBounds.find(analysis.id); bounds != grounds.lowerBounds.end())
            for (Metric &metric : metrics)
                metric.isAtLeast = std::ranges::find(bounds->second, metric.name) != bounds->second.end();
        if (const auto score = grounds.scores.find({trial.id, analysis.robot}); score != grounds.scores.end())
            metrics.push_back(score->second);
    }
    return runs;
}

/// Of a metric, one for each unit that its values have.
void addColumns(const std::vector<Run> &runs, const std::string &metric,
                std::vector<TrialTableColumn> &columns)
{
    std::set<std::string> units;
    for (const Run &run : runs)
        for (const Metric &one : run.metrics)
            if (one.name == metric)
                units.insert(one.unit);
    if (units.empty())
        units.insert(metricKind(metric) ? std::string(metricKind(metric)->unit) : std::string("1"));
    for (const std::string &unit : units)
        columns.push_back({metric, unit});
}

/// All that a run has: those that this program knows in its order, then any others.
std::vector<std::string> metricsOf(const std::vector<Run> &runs)
{
    std::set<std::string> others;
    for (const Run &run : runs)
        for (const Metric &metric : run.metrics)
            others.insert(metric.name);
    std::vector<std::string> metrics;
    for (const MetricKind &kind : metricKinds())
        if (others.erase(std::string(kind.id)) > 0)
            metrics.emplace_back(kind.id);
    metrics.insert(metrics.end(), others.begin(), others.end());
    return metrics;
}

} // namespace

Result<ResultTable> readTrialTable(Project &project, const TrialTableChoice &given)
{
    const auto choice = ODO_TRY(checked(project, given));
    auto trials = ODO_TRY(project.trials().all());
    std::erase_if(trials, [&](const TrialRecord &trial) { return !isChosen(trial, choice); });
    std::ranges::reverse(trials);
    const auto grounds = ODO_TRY(readGrounds(project, trials));
    std::vector<Run> runs;
    for (const TrialRecord &trial : trials) {
        auto its = ODO_TRY(runsOf(project, trial, grounds));
        std::ranges::move(its, std::back_inserter(runs));
    }
    ResultTable table;
    std::set<std::string> variables;
    for (const TrialRecord &trial : trials)
        for (const auto &variable : trial.variables)
            variables.insert(variable.first);
    table.variables.assign(variables.begin(), variables.end());
    for (const std::string &metric : choice.metrics.empty() ? metricsOf(runs) : choice.metrics)
        addColumns(runs, metric, table.columns);
    for (Run &run : runs) {
        for (const TrialTableColumn &column : table.columns) {
            const auto its = std::ranges::find_if(run.metrics, [&](const Metric &metric) {
                return metric.name == column.metric && metric.unit == column.unit;
            });
            run.row.metrics.push_back(its == run.metrics.end() ? std::nullopt : std::optional(*its));
        }
        table.rows.push_back(std::move(run.row));
    }
    return table;
}

} // namespace odo
