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

} // namespace

const TeamStanding *nameBestRun(BoardContent &content)
{
    const Standings &standings = content.reading.standings;
    const TeamStanding *best = nullptr;
    for (const TeamStanding &team : standings.teams)
        if (!best || (standings.isLessBetter ? team.progress.best < best->progress.best
                                             : team.progress.best > best->progress.best))
            best = &team;
    if (best) {
        content.bestTeam = best->team;
        content.bestPseudonym = best->pseudonym;
        content.best = best->bestRun().metric;
    }
    return best;
}

Result<void> BestRunMap::show(BoardContent &content, const std::string &key, const std::string &robot,
                              const std::function<Result<TrialScenePtr>()> &load)
{
    if (key != m_key) {
        const auto loaded = ODO_TRY(load());
        m_scene.reset();
        if (loaded) {
            auto scene = std::make_shared<TrialScene>(*loaded);
            for (SceneRobot &each : scene->robots)
                each.observations.clear(); // which are most of its memory
            const auto found = std::ranges::find(scene->robots, robot,
                                                 [](const SceneRobot &each) { return each.robot.name; });
            if (found != scene->robots.end() && found->analysis) {
                m_robot = std::size_t(found - scene->robots.begin());
                m_scene = std::move(scene);
            }
        }
        ++m_version;
        m_key = key;
    }
    content.scene = m_scene;
    content.robot = m_robot;
    content.mapVersion = m_version;
    return {};
}

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
    return content;
}

Result<void> BoardReader::addBestRun(BoardContent &content)
{
    const TeamStanding *team = nameBestRun(content);
    if (!team)
        return {};
    const TeamRun &run = team->bestRun();
    const auto trial = ODO_TRY(m_project.trials().find(run.trial));
    const auto analyses = ODO_TRY(m_project.analyses().currentMetrics(trial.id));
    const auto analysis = std::ranges::find(analyses, run.robot, &AnalysisRecord::robot);
    if (analysis == analyses.end())
        return {};
    return m_map.show(content, run.trial + '\n' + std::to_string(analysis->id), analysis->robotName,
                      [&] { return loadTrialScene(m_project, run.trial); });
}

} // namespace odo
