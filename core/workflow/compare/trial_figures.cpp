// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/compare/trial_figures.h"

#include "core/base/percentile.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <set>

namespace odo {

Result<std::vector<TrialScore>> trialScores(Project &project, Instant from, Instant to)
{
    const auto scorings = ODO_TRY(project.tasks().scorings());
    if (scorings.empty())
        return std::vector<TrialScore>();
    const auto runs = ODO_TRY(project.analyses().scoredFigures(from, to));
    std::vector<TrialScore> scores;
    for (const ScoredFigures &run : runs) {
        const auto scoring = scorings.find(run.task);
        if (scoring == scorings.end())
            continue;
        scores.push_back({run.trial, run.robot, run.task, {}});
        if (run.isByTask)
            scores.back().score = scoreOf(scoring->second, run.metrics);
    }
    return scores;
}

Result<std::vector<TrialFigure>> scoreFigures(Project &project, Instant from, Instant to)
{
    const auto scores = ODO_TRY(trialScores(project, from, to));
    std::vector<TrialFigure> figures;
    for (const TrialScore &run : scores)
        if (run.score)
            figures.push_back(
                {run.trial, run.robot, {scoreMetric, "points", run.score->points, run.score->sigma}});
    return figures;
}

Result<std::vector<TrialFigure>> figuresOf(Project &project, const std::string &metric)
{
    return metric == scoreMetric ? scoreFigures(project, Instant::min(), Instant::max())
                                 : project.analyses().figures(metric, Instant::min(), Instant::max());
}

bool countsIn(const TrialRecord &trial, const std::string &className, const std::string &task)
{
    return !trial.binned && (className.empty() || trial.className == className) &&
           (task.empty() || trial.task == task);
}

CountedTrials countedTrials(std::span<const TrialRecord *const> trials, const std::string &className,
                            const std::string &task, const std::vector<OtherwiseMeasured> &otherwise)
{
    CountedTrials counted;
    for (const TrialRecord *trial : trials) {
        if (!countsIn(*trial, className, task))
            continue;
        if (!task.empty() && std::ranges::binary_search(otherwise, trial->id, {}, &OtherwiseMeasured::trial))
            ++counted.leftOut;
        else
            counted.trials.push_back(trial);
    }
    return counted;
}

CountedTrials countedTrials(const std::vector<TrialRecord> &trials, const std::string &className,
                            const std::string &task, const std::vector<OtherwiseMeasured> &otherwise)
{
    std::vector<const TrialRecord *> all;
    for (const TrialRecord &trial : trials)
        all.push_back(&trial);
    return countedTrials(all, className, task, otherwise);
}

Result<std::map<std::string, ClassFigure>> classFigures(Project &project, const std::string &className,
                                                        const std::string &task,
                                                        const std::vector<std::string> &metrics)
{
    const auto trials = ODO_TRY(project.trials().all());
    const auto otherwise = ODO_TRY(project.analyses().trialsMeasuredOtherwise());
    std::set<RecordId> counted;
    for (const TrialRecord *trial : countedTrials(trials, className, task, otherwise).trials)
        counted.insert(trial->id);
    std::map<std::string, ClassFigure> figures;
    for (const std::string &metric : metrics) {
        const auto all = ODO_TRY(figuresOf(project, metric));
        std::vector<double> values;
        for (const TrialFigure &figure : all)
            if (counted.contains(figure.trial))
                values.push_back(figure.metric.value);
        if (!values.empty()) {
            const int runs = int(values.size());
            figures[metric] = {median(std::move(values)), runs};
        }
    }
    return figures;
}

} // namespace odo
