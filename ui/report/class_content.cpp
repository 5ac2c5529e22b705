// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/class_content.h"

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/counted_trials.h"
#include "core/workflow/trial_scores.h"
#include "ui/models/metric_choice.h"

#include <algorithm>
#include <map>

namespace odo {

namespace {

tl::unexpected<Error> notThere(const std::string &what, const std::vector<std::string> &there, const std::string &advice)
{
    std::string names;
    for (const std::string &name : there)
        names += (names.empty() ? "'" : ", '") + name + "'";
    return fail(ErrorCode::NotFound, what, names.empty() ? "the project has none" : "the project has " + names, advice);
}

Result<void> checkClass(Project &project, const std::string &name)
{
    const auto classes = project.classes().all();
    if (!classes)
        return tl::unexpected(classes.error());
    std::vector<std::string> names;
    for (const ClassRecord &each : *classes)
        names.push_back(each.name);
    if (std::ranges::find(names, name) == names.end())
        return notThere("class '" + name + "'", names, "choose one of them, or make it in the workbench");
    return {};
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

/// The score where the task is scored, else what tells most of those that there are.
Result<std::string> usualMetric(Project &project, const std::string &task)
{
    if (!task.empty()) {
        const auto record = project.tasks().find(task);
        if (!record)
            return tl::unexpected(record.error());
        const auto scoring = project.tasks().scoring(record->id);
        if (!scoring)
            return tl::unexpected(scoring.error());
        if (!scoring->empty())
            return std::string(scoreMetric);
    }
    const auto names = project.analyses().metricNames();
    if (!names)
        return tl::unexpected(names.error());
    const std::vector<std::string> telling = tellingNames(*names);
    return telling.empty() ? std::string() : telling.front();
}

} // namespace

Result<ClassContentPtr> readClassContent(Project &project, const ClassReportSettings &settings)
{
    if (auto known = checkClass(project, settings.className); !known)
        return tl::unexpected(known.error());
    const auto all = project.trials().all();
    if (!all)
        return tl::unexpected(all.error());
    auto content = std::make_shared<ClassContent>();
    content->settings = settings;
    ClassReportSettings &chosen = content->settings;
    if (chosen.task.empty())
        chosen.task = usualTask(*all, chosen.className);
    else if (const auto task = project.tasks().find(chosen.task); !task)
        return tl::unexpected(task.error());
    if (chosen.metric.empty()) {
        auto metric = usualMetric(project, chosen.task);
        if (!metric)
            return tl::unexpected(metric.error());
        chosen.metric = std::move(*metric);
    }
    const auto figures = figuresOf(project, chosen.metric);
    if (!figures)
        return tl::unexpected(figures.error());
    const auto otherwise = project.analyses().trialsMeasuredOtherwise();
    if (!otherwise)
        return tl::unexpected(otherwise.error());
    const CountedTrials counted = countedTrials(*all, chosen.className, chosen.task, *otherwise);
    content->trials = int(counted.trials.size()) + counted.leftOut;
    content->leftOut = counted.leftOut;
    content->standings = standingsOf(counted.trials, *figures, {chosen.className, chosen.task, chosen.metric});
    if (content->standings.teams.empty())
        return fail(ErrorCode::NotFound, "report of class '" + chosen.className + "'",
                    "none of its teams has a run with the figure '" + chosen.metric + "'" +
                        (chosen.task.empty() ? "" : " in the task '" + chosen.task + "'"),
                    "track its trials, or choose another task or figure");
    return content;
}

} // namespace odo
