// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/scoring.h"
#include "core/analysis/term_progress.h"
#include "core/base/error.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/project/verdict_repository.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace odo {

class Project;

/// By which a score is known among the metrics of trials; a higher one is better.
constexpr const char *scoreMetric = "score";

/// What a robot's run in a trial of a scored task is worth.
struct TrialScore
{
    RecordId trial = 0, robot = 0, task = 0;
    /// nullopt: its newest analysis was measured by another task than the trial has, or by it as it was
    /// before it was changed.
    std::optional<Score> score;
};

/// Of each robot in the trials from one moment to another (both belong to them) whose task is scored, by its
/// newest analysis. Computed from what is stored, so that another scoring counts at once. On the project's
/// thread.
Result<std::vector<TrialScore>> trialScores(Project &project, Instant from, Instant to);

/// The same as metric values named scoreMetric; runs without a score are left out.
Result<std::vector<TrialMetric>> scoreMetrics(Project &project, Instant from, Instant to);

/// A metric value of the newest analysis of each robot, of all trials: a metric by its name, or the score by
/// scoreMetric.
Result<std::vector<TrialMetric>> metricsOf(Project &project, const std::string &metric);

/// Whether a trial belongs to a class and to a task (empty: to any) and is not in the bin. Pure.
bool countsIn(const TrialRecord &trial, const std::string &className, const std::string &task);

/// By what trials are left out of comparisons.
struct CountingGrounds
{
    std::vector<OtherwiseMeasured> otherwise;  ///< in order of their ids
    std::map<RecordId, TrialVerdict> verdicts; ///< as trialVerdicts()
};
/// For the trials of a class and a task (empty: of any). Errors: those of the repositories and of
/// trialVerdicts(). On the thread of the project.
Result<CountingGrounds> countingGrounds(Project &project, const std::string &className,
                                        const std::string &task);

/// Trials whose metrics can be compared, in their order; they must outlive it.
struct CountedTrials
{
    std::vector<const TrialRecord *> trials;
    std::set<RecordId> doubtful = {}; ///< of them, whose verdict is doubtful and was not accepted
    int leftOut = 0; ///< that belong to the task, and were measured by another course than it has now
    int bad = 0;     ///< that are left out for a bad verdict
};
/// Those that count in a class and a task (countsIn), without bad ones and those that were measured
/// otherwise; of any task none is left out for that. Pure.
CountedTrials countedTrials(std::span<const TrialRecord *const> trials, const std::string &className,
                            const std::string &task, const CountingGrounds &grounds);
CountedTrials countedTrials(const std::vector<TrialRecord> &trials, const std::string &className,
                            const std::string &task, const CountingGrounds &grounds);

/// The median of a metric in a class.
struct ClassMedian
{
    double median = 0;
    int runs = 0; ///< each robot's in each trial
};

/// The median of each metric over the runs of a class in a task, by the metrics' names; those that no run has
/// are not in it. Of trials that count there (countedTrials). On the project's thread. Errors: those of the
/// repositories.
Result<std::map<std::string, ClassMedian>> classMedians(Project &project, const std::string &className,
                                                        const std::string &task,
                                                        const std::vector<std::string> &metrics);

/// What teams are compared by.
struct StandingsChoice
{
    std::string className; ///< empty: all classes
    /// empty: any task; then nobody is ranked, for runs of different tasks cannot be compared
    std::string task;
    std::string metric;
};

/// A team's metric value in one trial; of several robots the best one's.
struct TeamRun
{
    std::string trial;
    RecordId robot = 0; ///< that gave it
    Instant date;
    Metric metric;
    bool isDoubtful = false; ///< its verdict is, and was not accepted
};

struct TeamStanding
{
    std::string team, pseudonym, className;
    std::vector<TeamRun> runs; ///< in the order of time
    TeamStatistics statistics; ///< its runs' values, median, σ and rank
    TermProgress progress;
    int doubtfulRuns() const { return int(std::ranges::count_if(runs, &TeamRun::isDoubtful)); }
    /// The first of its runs with the best value.
    const TeamRun &bestRun() const
    {
        const auto found = std::ranges::find_if(
            runs, [this](const TeamRun &run) { return run.metric.value == progress.best; });
        return found == runs.end() ? runs.front() : *found;
    }
};

struct Standings
{
    StandingsChoice choice;
    bool isLessBetter = false;
    /// the best rank first, then by median; of any task by name; only those with a run
    std::vector<TeamStanding> teams;
    bool isRanked() const { return !choice.task.empty(); } ///< else every rank is 0
};

/// Best, median, repeatability, progress and rank of the teams (see termProgress, rankTeams). Trials in the
/// bin, without a team, of another class or task do not count. trialMetrics: of the metric, of these trials.
/// doubtful: trials that are marked so. Pure; any thread.
Standings standingsOf(std::span<const TrialRecord *const> trials,
                      const std::vector<TrialMetric> &trialMetrics, const StandingsChoice &choice,
                      const std::set<RecordId> &doubtful = {});

} // namespace odo
