// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/compare/standings.h"

#include "core/workflow/compare/trial_figures.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

namespace odo {

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
    std::vector<TermFigure> course;
    for (const TeamRun &run : team.runs) {
        team.figures.values.push_back(run.metric.value);
        course.push_back({daysOf(run.date), run.metric.value});
    }
    team.progress = termProgress(course, isLessBetter);
}

} // namespace

Standings standingsOf(std::span<const TrialRecord *const> trials, const std::vector<TrialFigure> &figures,
                      const StandingsChoice &choice)
{
    Standings standings{choice, isLessBetter(choice.metric), {}};
    std::unordered_map<RecordId, Metric> best;
    for (const TrialFigure &figure : figures) {
        const auto [known, isNew] = best.try_emplace(figure.trial, figure.metric);
        if (!isNew && (standings.isLessBetter ? figure.metric.value < known->second.value
                                              : figure.metric.value > known->second.value))
            known->second = figure.metric;
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
        team.runs.push_back({trial->name, trial->date, metric->second});
    }
    std::vector<TeamFigures> ranked;
    for (auto &[id, team] : teams) {
        measure(team, standings.isLessBetter);
        ranked.push_back(team.figures);
    }
    rankTeams(ranked, standings.isLessBetter);
    auto rank = ranked.begin();
    for (auto &[id, team] : teams) {
        team.figures = std::move(*rank++);
        standings.teams.push_back(std::move(team));
    }
    if (!standings.isRanked()) {
        for (TeamStanding &team : standings.teams)
            team.figures.rank = 0;
        std::ranges::stable_sort(standings.teams, {}, &TeamStanding::team);
        return standings;
    }
    const double sign = standings.isLessBetter ? 1 : -1;
    std::ranges::stable_sort(standings.teams, {}, [sign](const TeamStanding &team) {
        return std::tuple(team.figures.rank, sign * team.figures.median);
    });
    return standings;
}

} // namespace odo
