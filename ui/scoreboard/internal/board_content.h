// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/workflow/compare/standings_reading.h"
#include "ui/models/trial_scene.h"

#include <functional>
#include <optional>
#include <string>

namespace odo {

class Project;

/// A recording that is going on.
struct RunningRecording
{
    std::string team, pseudonym; ///< empty: the trial has no team
    Instant since;
};

/// What the page of the standings shows, in no language yet. Values; any thread.
struct BoardContent
{
    StandingsReading reading;
    std::optional<Error> problem; ///< why it is not read anew
    std::optional<RunningRecording> running;
    std::string bestTeam;        ///< whose run the map shows; empty: there is none
    std::string bestPseudonym;   ///< of that team
    std::optional<Metric> best;  ///< of that run
    TrialScenePtr scene;         ///< of that run, without observations; null: it has no map
    std::size_t robot = 0;       ///< in the scene
    std::int64_t mapVersion = 0; ///< goes on with each other map
};

/// The team with the best run of all, which the content now names with that run; null: none has any.
const TeamStanding *nameBestRun(BoardContent &content);

/// The map of the best run, read only where it is another one.
class BestRunMap
{
public:
    /// key: another one for another run or other results of it.
    Result<void> show(BoardContent &content, const std::string &key, const std::string &robot,
                      const std::function<Result<TrialScenePtr>()> &load);

private:
    std::string m_key; ///< of what is shown
    TrialScenePtr m_scene;
    std::size_t m_robot = 0;
    std::int64_t m_version = 0;
};

/// Reads it from a project, again and again. On the thread of the project, which must outlive it.
class BoardReader
{
public:
    /// choice: what is empty in it is chosen at each reading: the task of the newest trial that has one, then
    /// as readStandings() does.
    BoardReader(Project &project, StandingsChoice choice);

    /// Errors: those of readStandings() and of loadTrialScene().
    Result<BoardContent> read();
    /// Whether what was read may have changed: by the project's state, or because a recording began or ended.
    /// Cheap. False where it cannot be asked now.
    bool hasChanged();

private:
    Result<void> addBestRun(BoardContent &content);

    Project &m_project;
    const StandingsChoice m_choice;
    std::int64_t m_byOthers = -1;
    bool m_hasUnfinished = false, m_isRecording = false;
    BestRunMap m_map;
};

} // namespace odo
