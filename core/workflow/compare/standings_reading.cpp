// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/compare/standings_reading.h"

#include "core/analysis/metric_table.h"
#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"

#include <algorithm>
#include <map>

namespace odo {

namespace {

Result<void> checkClass(const std::vector<ClassRecord> &classes, const std::string &name)
{
    if (name.empty() || std::ranges::find(classes, name, &ClassRecord::name) != classes.end())
        return {};
    std::vector<std::string> names;
    for (const ClassRecord &each : classes)
        names.push_back(each.name);
    return fail(ErrorCode::NotFound, classSubject(name),
                names.empty() ? Message(ODO_TEXT("ui.project_has_no_class", "the project has none"))
                              : ODO_TEXT("ui.project_has_classes", "the project has %1")(
                                    quotedNames(names, MessageArgument::Kind::Class)),
                ODO_TEXT("ui.choose_or_make_class", "choose one of them, or create it in the workbench"));
}

/// The task that most trials of the class have; empty: none has one.
std::string usualTask(const std::vector<TrialRecord> &trials, const std::string &className)
{
    std::map<std::string, int> counts;
    for (const TrialRecord &trial : trials)
        if (!trial.task.empty() && countsIn(trial, className, {}))
            ++counts[trial.task];
    const auto most = std::ranges::max_element(counts, {}, [](const auto &each) { return each.second; });
    return most == counts.end() ? std::string() : most->first;
}

/// The score where the task is scored, else the most informative metric available.
Result<std::string> usualMetric(Project &project, const std::string &task)
{
    if (!task.empty()) {
        const auto record = ODO_TRY(project.tasks().find(task));
        const auto scoring = ODO_TRY(project.tasks().scoring(record.id));
        if (!scoring.empty())
            return std::string(scoreMetric);
    }
    const auto names = ODO_TRY(project.analyses().metricNames());
    for (const MetricKind &kind : metricKinds())
        if (std::ranges::find(names, kind.id) != names.end())
            return std::string(kind.id);
    return names.empty() ? std::string() : names.front();
}

} // namespace

Result<StandingsReading> readStandings(Project &project, std::vector<TrialRecord> trials,
                                       StandingsChoice choice)
{
    const auto classes = ODO_TRY(project.classes().all());
    ODO_TRY(checkClass(classes, choice.className));
    if (choice.className.empty())
        std::erase_if(trials, [&classes](const TrialRecord &trial) {
            const auto own = std::ranges::find(classes, trial.className, &ClassRecord::name);
            return own != classes.end() && own->archived;
        });
    if (choice.task.empty())
        choice.task = usualTask(trials, choice.className);
    else if (const auto task = project.tasks().find(choice.task); !task)
        return tl::unexpected(task.error());
    if (choice.metric.empty()) {
        auto metric = ODO_TRY(usualMetric(project, choice.task));
        choice.metric = std::move(metric);
    }
    const auto trialMetrics = ODO_TRY(metricsOf(project, choice.metric));
    const auto grounds = ODO_TRY(countingGrounds(project, choice.className, choice.task));
    const CountedTrials counted = countedTrials(trials, choice.className, choice.task, grounds);
    StandingsReading reading;
    reading.trials = int(counted.trials.size()) + counted.leftOut + counted.bad;
    reading.leftOut = counted.leftOut;
    reading.bad = counted.bad;
    reading.standings = standingsOf(counted.trials, trialMetrics, choice, counted.doubtful);
    return reading;
}

} // namespace odo
