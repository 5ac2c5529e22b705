// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/compare/trial_metrics.h"

#include "core/base/percentile.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/stored_verdicts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

namespace odo {

Result<std::vector<TrialScore>> trialScores(Project &project, Instant from, Instant to)
{
    const auto scorings = ODO_TRY(project.tasks().scorings());
    if (scorings.empty())
        return std::vector<TrialScore>();
    const auto runs = ODO_TRY(project.analyses().scoredMetrics(from, to));
    std::vector<TrialScore> scores;
    for (const ScoredMetrics &run : runs) {
        const auto scoring = scorings.find(run.task);
        if (scoring == scorings.end())
            continue;
        scores.push_back({run.trial, run.robot, run.task, {}});
        if (run.isByTask)
            scores.back().score = scoreOf(scoring->second, run.metrics);
    }
    return scores;
}

Result<std::vector<TrialMetric>> scoreMetrics(Project &project, Instant from, Instant to)
{
    const auto scores = ODO_TRY(trialScores(project, from, to));
    std::vector<TrialMetric> trialMetrics;
    for (const TrialScore &run : scores)
        if (run.score)
            trialMetrics.push_back(
                {run.trial, run.robot, {scoreMetric, "points", run.score->points, run.score->sigma}});
    return trialMetrics;
}

Result<std::vector<TrialMetric>> metricsOf(Project &project, const std::string &metric)
{
    return metric == scoreMetric ? scoreMetrics(project, Instant::min(), Instant::max())
                                 : project.analyses().trialMetrics(metric, Instant::min(), Instant::max());
}

bool countsIn(const TrialRecord &trial, const std::string &className, const std::string &task)
{
    return !trial.binned && (className.empty() || trial.className == className) &&
           (task.empty() || trial.task == task);
}

Result<CountingGrounds> countingGrounds(Project &project, const std::string &className,
                                        const std::string &task)
{
    const auto trials = ODO_TRY(project.trials().all());
    std::set<RecordId> wanted;
    for (const TrialRecord &trial : trials)
        if (countsIn(trial, className, task))
            wanted.insert(trial.id);
    auto otherwise = ODO_TRY(project.analyses().trialsMeasuredOtherwise());
    auto verdicts = ODO_TRY(trialVerdicts(project, wanted));
    return CountingGrounds{std::move(otherwise), std::move(verdicts)};
}

CountedTrials countedTrials(std::span<const TrialRecord *const> trials, const std::string &className,
                            const std::string &task, const CountingGrounds &grounds)
{
    CountedTrials counted;
    for (const TrialRecord *trial : trials) {
        if (!countsIn(*trial, className, task))
            continue;
        if (!task.empty() &&
            std::ranges::binary_search(grounds.otherwise, trial->id, {}, &OtherwiseMeasured::trial)) {
            ++counted.leftOut;
            continue;
        }
        const auto verdict = grounds.verdicts.find(trial->id);
        if (verdict != grounds.verdicts.end() && verdict->second.level() == CheckLevel::Bad) {
            ++counted.bad;
            continue;
        }
        counted.trials.push_back(trial);
        if (verdict != grounds.verdicts.end() && !verdict->second.isSound())
            counted.doubtful.insert(trial->id);
    }
    return counted;
}

CountedTrials countedTrials(const std::vector<TrialRecord> &trials, const std::string &className,
                            const std::string &task, const CountingGrounds &grounds)
{
    std::vector<const TrialRecord *> all;
    for (const TrialRecord &trial : trials)
        all.push_back(&trial);
    return countedTrials(all, className, task, grounds);
}

Result<std::map<std::string, ClassMedian>> classMedians(Project &project, const std::string &className,
                                                        const std::string &task,
                                                        const std::vector<std::string> &metrics)
{
    const auto trials = ODO_TRY(project.trials().all());
    const auto grounds = ODO_TRY(countingGrounds(project, className, task));
    std::set<RecordId> counted;
    for (const TrialRecord *trial : countedTrials(trials, className, task, grounds).trials)
        counted.insert(trial->id);
    std::map<std::string, ClassMedian> trialMetrics;
    for (const std::string &metric : metrics) {
        const auto all = ODO_TRY(metricsOf(project, metric));
        std::vector<double> values;
        for (const TrialMetric &trialMetric : all)
            if (counted.contains(trialMetric.trial))
                values.push_back(trialMetric.metric.value);
        if (!values.empty()) {
            const int runs = int(values.size());
            trialMetrics[metric] = {median(std::move(values)), runs};
        }
    }
    return trialMetrics;
}

namespace {

double daysOf(Instant instant)
{
    return std::chrono::duration<double, std::ratio<86400>>(instant.time_since_epoch()).count();
}

bool counts(const TrialRecord &trial, const StandingsChoice &choice)
{
    return trial.team != 0 && countsIn(trial, choice.className, choice.task);
}

void measure(TeamStanding &team, bool isLessBetter)
{
    std::ranges::stable_sort(team.runs, {}, &TeamRun::date);
    std::vector<TermValue> course;
    double squares = 0;
    for (const TeamRun &run : team.runs) {
        team.statistics.values.push_back(run.metric.value);
        course.push_back({daysOf(run.date), run.metric.value});
        squares += std::pow(run.metric.sigma.value_or(0), 2);
    }
    team.statistics.runSigma = std::sqrt(squares / double(team.runs.size()));
    team.progress = termProgress(course, isLessBetter);
}

} // namespace

Standings standingsOf(std::span<const TrialRecord *const> trials,
                      const std::vector<TrialMetric> &trialMetrics, const StandingsChoice &choice,
                      const std::set<RecordId> &doubtful)
{
    Standings standings{choice, isLessBetter(choice.metric), {}};
    std::unordered_map<RecordId, const TrialMetric *> best;
    for (const TrialMetric &trialMetric : trialMetrics) {
        const auto [known, isNew] = best.try_emplace(trialMetric.trial, &trialMetric);
        const double other = known->second->metric.value;
        if (!isNew &&
            (standings.isLessBetter ? trialMetric.metric.value < other : trialMetric.metric.value > other))
            known->second = &trialMetric;
    }
    std::map<RecordId, TeamStanding> teams;
    for (const TrialRecord *trial : trials) {
        const auto metric = best.find(trial->id);
        if (metric == best.end() || !counts(*trial, choice))
            continue;
        TeamStanding &team = teams[trial->team];
        team.team = trial->teamName;
        team.pseudonym = trial->teamPseudonym;
        team.className = trial->className;
        team.runs.push_back({trial->name, metric->second->robot, trial->date, metric->second->metric,
                             doubtful.contains(trial->id)});
    }
    std::vector<TeamStatistics> ranked;
    for (auto &[id, team] : teams) {
        measure(team, standings.isLessBetter);
        ranked.push_back(team.statistics);
    }
    rankTeams(ranked, standings.isLessBetter);
    auto rank = ranked.begin();
    for (auto &[id, team] : teams) {
        team.statistics = std::move(*rank++);
        standings.teams.push_back(std::move(team));
    }
    if (!standings.isRanked()) {
        for (TeamStanding &team : standings.teams)
            team.statistics.rank = 0;
        std::ranges::stable_sort(standings.teams, {}, &TeamStanding::team);
        return standings;
    }
    const double sign = standings.isLessBetter ? 1 : -1;
    std::ranges::stable_sort(standings.teams, {}, [sign](const TeamStanding &team) {
        return std::tuple(team.statistics.rank, sign * team.statistics.median);
    });
    return standings;
}

} // namespace odo
