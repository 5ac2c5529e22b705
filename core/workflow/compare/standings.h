// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/term_progress.h"
#include "core/project/records.h"

#include <span>
#include <string>
#include <vector>

namespace odo {

/// What teams are compared by.
struct StandingsChoice
{
    std::string className; ///< empty: all classes
    /// empty: any task; then nobody is ranked, for runs of different tasks cannot be compared
    std::string task;
    std::string metric;
};

/// A team's figure in one trial; of several robots the best one's.
struct TeamRun
{
    std::string trial;
    Instant date;
    Metric metric;
};

struct TeamStanding
{
    std::string team, pseudonym, className;
    std::vector<TeamRun> runs; ///< in the order of time
    TeamFigures figures;       ///< its runs' values, median, σ and rank
    TermProgress progress;
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
/// bin, without a team, of another class or task do not count. figures: of the metric, of these trials. Pure;
/// any thread.
Standings standingsOf(std::span<const TrialRecord *const> trials, const std::vector<TrialFigure> &figures,
                      const StandingsChoice &choice);

} // namespace odo
