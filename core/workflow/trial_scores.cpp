// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trial_scores.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

namespace odo {

Result<std::vector<TrialScore>> trialScores(Project &project, Instant from, Instant to)
{
    const auto scorings = project.tasks().scorings();
    if (!scorings)
        return tl::unexpected(scorings.error());
    if (scorings->empty())
        return std::vector<TrialScore>();
    const auto runs = project.analyses().scoredFigures(from, to);
    if (!runs)
        return tl::unexpected(runs.error());
    std::vector<TrialScore> scores;
    for (const ScoredFigures &run : *runs) {
        const auto scoring = scorings->find(run.task);
        if (scoring == scorings->end())
            continue;
        scores.push_back({run.trial, run.robot, run.task, {}});
        if (run.isByTask)
            scores.back().score = scoreOf(scoring->second, run.metrics);
    }
    return scores;
}

Result<std::vector<TrialFigure>> scoreFigures(Project &project, Instant from, Instant to)
{
    const auto scores = trialScores(project, from, to);
    if (!scores)
        return tl::unexpected(scores.error());
    std::vector<TrialFigure> figures;
    for (const TrialScore &run : *scores)
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

} // namespace odo
