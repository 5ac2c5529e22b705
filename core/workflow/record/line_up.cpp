// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/line_up.h"

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <set>

namespace odo {

Result<TrialRecord> trialOf(Project &project, const NextRun &run)
{
    TrialRecord trial;
    trial.name = run.trial;
    trial.task = run.task;
    if (!run.team.empty()) {
        const auto team = ODO_TRY(project.teams().find(run.team));
        trial.team = team.id;
    }
    for (const std::string &name : run.robots) {
        const auto robot = ODO_TRY(project.robots().find(name));
        trial.robots.push_back(robot.id);
    }
    return trial;
}

Result<LineUp> LineUp::read(Project &project, bool byPseudonym)
{
    auto teams = project.teams().all();
    const auto classes = project.classes().all();
    auto tasks = project.tasks().current();
    auto robots = project.robots().all();
    auto trials = project.trials().names();
    if (!teams)
        return tl::unexpected(teams.error());
    if (!classes)
        return tl::unexpected(classes.error());
    if (!tasks)
        return tl::unexpected(tasks.error());
    if (!robots)
        return tl::unexpected(robots.error());
    if (!trials)
        return tl::unexpected(trials.error());
    std::erase_if(*teams, [&classes](const TeamRecord &team) {
        const auto of = std::ranges::find(*classes, team.className, &ClassRecord::name);
        return of != classes->end() && of->archived;
    });
    LineUp up;
    up.m_byPseudonym = byPseudonym;
    up.m_teams = std::move(*teams);
    up.m_tasks = std::move(*tasks);
    up.m_robots = std::move(*robots);
    up.m_trials = std::move(*trials);
    std::ranges::sort(up.m_teams, {}, &TeamRecord::name);
    std::set<std::string> known;
    for (const TrialName &trial : up.m_trials) {
        if (!known.insert(trial.teamName).second)
            continue;
        up.m_newest.push_back(ODO_TRY(project.trials().get(trial.id)));
    }
    return up;
}

std::vector<std::string> LineUp::classes() const
{
    std::set<std::string> names;
    for (const TeamRecord &team : m_teams)
        names.insert(team.className);
    return {names.begin(), names.end()};
}

std::vector<std::string> LineUp::teams(const std::string &className) const
{
    std::vector<std::string> names;
    for (const TeamRecord &team : m_teams) {
        if (team.className == className)
            names.push_back(team.name);
    }
    return names;
}

std::string LineUp::pseudonymOf(const std::string &team) const
{
    const auto known = std::ranges::find(m_teams, team, &TeamRecord::name);
    return known == m_teams.end() ? std::string() : known->pseudonym;
}

std::vector<std::string> LineUp::robotsOf(const std::string &team) const
{
    std::vector<std::string> names;
    if (const auto known = std::ranges::find(m_teams, team, &TeamRecord::name); known != m_teams.end())
        for (const RecordId id : known->robots)
            if (const auto robot = std::ranges::find(m_robots, id, &RobotRecord::id); robot != m_robots.end())
                names.push_back(robot->name);
    return names;
}

const TaskRecord *LineUp::task(const std::string &name) const
{
    const auto task = std::ranges::find(m_tasks, name, &TaskRecord::name);
    return task == m_tasks.end() ? nullptr : &*task;
}

const TrialRecord *LineUp::newestOf(const std::string &team) const
{
    const auto trial =
        std::ranges::find_if(m_newest, [&](const TrialRecord &each) { return each.teamName == team; });
    return trial == m_newest.end() ? nullptr : &*trial;
}

NextRun LineUp::run(const std::string &className, const std::string &team) const
{
    NextRun run{className, team, {}, {}, freeTrialName(team)};
    const TrialRecord *newest = newestOf(team);
    run.robots = robotsOf(team);
    if (run.robots.empty() && newest)
        run.robots = newest->robotNames;
    if (run.robots.empty()) {
        for (const RobotRecord &robot : m_robots)
            run.robots.push_back(robot.name);
    }
    const TrialRecord *last = newest ? newest : m_newest.empty() ? nullptr : &m_newest.front();
    if (last && task(last->task)) // else it is archived
        run.task = last->task;
    return run;
}

NextRun LineUp::next(const NextRun &before) const
{
    const std::vector<std::string> all = teams(before.className);
    if (all.empty() || before.team.empty()) {
        NextRun again = before;
        again.trial = freeTrialName(before.team);
        return again;
    }
    const auto now = std::ranges::find(all, before.team);
    const bool last = now == all.end() || now + 1 == all.end();
    NextRun next = run(before.className, last ? all.front() : *(now + 1));
    next.task = before.task;
    return next;
}

NextRun LineUp::first() const
{
    if (m_teams.empty())
        return run({}, {});
    const auto last = std::ranges::find_if(m_newest, [this](const TrialRecord &trial) {
        return std::ranges::find(m_teams, trial.teamName, &TeamRecord::name) != m_teams.end();
    });
    if (last == m_newest.end())
        return run(m_teams.front().className, m_teams.front().name);
    NextRun before = run(last->className, last->teamName);
    before.task = last->task;
    return next(before);
}

std::string LineUp::freeTrialName(const std::string &team) const
{
    const std::string pseudonym = m_byPseudonym ? pseudonymOf(team) : std::string();
    const std::string stem = team.empty() ? "Trial" : pseudonym.empty() ? team : pseudonym;
    const auto same = std::ranges::count_if(
        m_trials, [&](const TrialName &trial) { return team.empty() || trial.teamName == team; });
    for (auto number = same + 1;; ++number) {
        std::string name = stem + " " + std::to_string(number);
        if (std::ranges::find(m_trials, name, &TrialName::name) == m_trials.end())
            return name;
    }
}

} // namespace odo
