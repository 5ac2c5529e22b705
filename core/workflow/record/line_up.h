// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// What is to be recorded next: who drives, what, and what the trial will be called.
struct NextRun
{
    std::string className = {}, team = {}; ///< either may be empty
    std::string task = {};                 ///< empty: none
    std::vector<std::string> robots = {};
    std::string trial = {}; ///< free in the project
};
/// A new trial of that name, team, task and robots. Project's thread. Errors: NotFound.
Result<TrialRecord> trialOf(Project &project, const NextRun &run);

/// The teams of a project in the order in which they come up, and what each drove last. A value, read at
/// once; any thread.
class LineUp
{
public:
    /// Project's thread.
    /// byPseudonym: names of trials are suggested by the pseudonyms of teams that have one. Teams of archived
    /// classes are not up.
    static Result<LineUp> read(Project &project, bool byPseudonym = false);

    /// Each once, in alphabetical order; an empty name stands for teams without a class.
    std::vector<std::string> classes() const;
    /// Of a class, in the order in which they come up: that of their names.
    std::vector<std::string> teams(const std::string &className) const;
    /// Empty where it has none.
    std::string pseudonymOf(const std::string &team) const;
    /// The robots that belong to a team; empty: it has none of its own.
    std::vector<std::string> robotsOf(const std::string &team) const;
    const std::vector<TaskRecord> &tasks() const { return m_tasks; }
    const std::vector<RobotRecord> &robots() const { return m_robots; }
    const TaskRecord *task(const std::string &name) const;

    /// A team's run: the robots that belong to it, or else those of its newest trial, or else all; the task
    /// as in its newest trial, or else the one that was driven last.
    NextRun run(const std::string &className, const std::string &team) const;
    /// The run of who comes after the team in its class, from the first again after the last; the task stays.
    NextRun next(const NextRun &before) const;
    /// Who is up when the session begins: after the team of the newest trial; with no team at all a run
    /// without one.
    NextRun first() const;
    /// "Falcon 3", or "Trial 3" without a team.
    std::string freeTrialName(const std::string &team) const;

private:
    const TrialRecord *newestOf(const std::string &team) const;

    bool m_byPseudonym = false;
    std::vector<TeamRecord> m_teams;
    std::vector<TaskRecord> m_tasks;
    std::vector<RobotRecord> m_robots;
    std::vector<TrialName> m_trials;   ///< newest first
    std::vector<TrialRecord> m_newest; ///< of each team, and of those without one; newest first
};

} // namespace odo
