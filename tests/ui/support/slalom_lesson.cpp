// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/slalom_lesson.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/stored_verdicts.h"
#include "tests/ui/support/example_scene.h"

#include <QString>

namespace odo::test {

namespace {

template <class T>
T had(Result<T> result)
{
    if (!result)
        qFatal("%s", result.error().message().c_str());
    return std::move(*result);
}

} // namespace

std::unique_ptr<Project> makeSlalomLesson(const std::filesystem::path &folder)
{
    auto project = had(Project::create(folder / "slalom.odo", "Slalom"));
    for (const char *team : {"Falcon", "Heron", "Otter"})
        had(project->teams().add({0, team, "9B"}));
    TaskRecord task;
    task.name = "Slalom";
    had(project->tasks().add(task));
    RobotRecord robot;
    robot.name = "Red";
    had(project->robots().add(robot));
    return project;
}

void addSlalomRun(Project &project, const std::string &team, double seconds)
{
    static const TrialScenePtr scene = exampleScene({60, 1, 320, 180, {}});
    const Result<void> added = project.inTransaction([&]() -> Result<void> {
        const auto before = ODO_TRY(project.trials().names());
        const RecordId robot = ODO_TRY(project.robots().find("Red")).id;
        TrialRecord trial;
        trial.name = "Run " + std::to_string(before.size() + 1);
        trial.team = ODO_TRY(project.teams().find(team)).id;
        trial.task = "Slalom";
        trial.date = Instant(std::chrono::hours(24 * 20000) + std::chrono::minutes(before.size()));
        trial.robots = {robot};
        trial = ODO_TRY(project.trials().add(trial, {}));
        AnalysisRecord analysis = *scene->robots.front().analysis;
        analysis.trial = trial.id;
        analysis.robot = robot;
        analysis.made = trial.date;
        analysis.registrations.clear();
        analysis.views.clear();
        analysis.profile.metrics = {{"gate_time", "s", seconds, 0.05}};
        ODO_TRY(project.analyses().add(analysis));
        return acceptVerdict(project, trial.name, "an example");
    });
    if (!added)
        qFatal("%s", added.error().message().c_str());
}

} // namespace odo::test
