// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/internal/board_content.h"

#include "core/project/project.h"
#include "core/project/project_locks.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <utility>

namespace odo {

namespace {

/// Of the class (empty: of any), by when they were made.
std::string taskOfNewestTrial(const std::vector<TrialRecord> &trials, const std::string &className)
{
    const TrialRecord *newest = nullptr;
    for (const TrialRecord &trial : trials)
        if (!trial.task.empty() && countsIn(trial, className, {}) && (!newest || trial.date > newest->date))
            newest = &trial;
    return newest ? newest->task : std::string();
}

/// The newest trial that is being recorded, or was when that was cut off.
const TrialRecord *newestUnfinished(const std::vector<TrialRecord> &trials)
{
    const TrialRecord *newest = nullptr;
    for (const TrialRecord &trial : trials)
        if (trial.unfinished && !trial.binned && (!newest || trial.date > newest->date))
            newest = &trial;
    return newest;
}

/// The team with the best run of all; null: none has any.
const TeamStanding *bestTeam(const Standings &standings)
{
    const TeamStanding *best = nullptr;
    for (const TeamStanding &team : standings.teams)
        if (!best || (standings.isLessBetter ? team.progress.best < best->progress.best
                                             : team.progress.best > best->progress.best))
            best = &team;
    return best;
}

} // namespace

BoardReader::BoardReader(Project &project, StandingsChoice choice)
    : m_project(project), m_choice(std::move(choice))
{
}

bool BoardReader::hasChanged()
{
    const auto state = m_project.state();
    return (state && state->byOthers != m_byOthers) ||
           (m_hasUnfinished && RecordingLock::isHeld(m_project.mediaFolder()) != m_isRecording);
}

Result<BoardContent> BoardReader::read()
{
    const auto state = ODO_TRY(m_project.state()); // before what is read: what changes meanwhile shows later
    auto trials = ODO_TRY(m_project.trials().all());
    StandingsChoice choice = m_choice;
    if (choice.task.empty())
        choice.task = taskOfNewestTrial(trials, choice.className);
    BoardContent content;
    const TrialRecord *unfinished = newestUnfinished(trials);
    m_hasUnfinished = unfinished != nullptr;
    m_isRecording = unfinished && RecordingLock::isHeld(m_project.mediaFolder());
    if (m_isRecording)
        content.running = {unfinished->teamName, unfinished->teamPseudonym, unfinished->date};
    auto reading = ODO_TRY(readStandings(m_project, std::move(trials), std::move(choice)));
    content.reading = std::move(reading);
    ODO_TRY(addBestRun(content));
    m_byOthers = state.byOthers;
    m_last = content;
    return content;
}

Result<void> BoardReader::addBestRun(BoardContent &content)
{
    const TeamStanding *team = bestTeam(content.reading.standings);
    if (!team)
        return {};
    const TeamRun &run = team->bestRun();
    content.bestTeam = team->team;
    content.bestPseudonym = team->pseudonym;
    content.best = run.metric;
    const auto trial = ODO_TRY(m_project.trials().find(run.trial));
    const auto analyses = ODO_TRY(m_project.analyses().currentMetrics(trial.id));
    const auto analysis = std::ranges::find(analyses, run.robot, &AnalysisRecord::robot);
    const ShownRun shown{run.trial, run.robot, analysis == analyses.end() ? 0 : analysis->id};
    if (shown == m_shown) {
        content.scene = m_last.scene;
        content.robot = m_last.robot;
        content.mapVersion = m_last.mapVersion;
        return {};
    }
    auto scene = std::make_shared<TrialScene>(*ODO_TRY(loadTrialScene(m_project, run.trial)));
    for (SceneRobot &each : scene->robots)
        each.observations.clear(); // which are most of its memory
    const auto robot =
        std::ranges::find(scene->robots, run.robot, [](const SceneRobot &each) { return each.robot.id; });
    if (robot != scene->robots.end() && robot->analysis) {
        content.robot = std::size_t(robot - scene->robots.begin());
        content.scene = std::move(scene);
    }
    content.mapVersion = m_last.mapVersion + 1;
    m_shown = shown;
    return {};
}

} // namespace odo
