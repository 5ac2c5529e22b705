// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/task_drafts.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

#include <algorithm>

namespace odo {

std::optional<MarkerLayout> layoutForTasks(Project &project)
{
    for (const CameraRecord &camera : project.cameras().all().value_or(std::vector<CameraRecord>())) {
        const auto registration = project.cameras().currentRegistration(camera.id);
        if (!registration || !*registration)
            continue;
        if (const auto layout = project.layouts().get((*registration)->layout))
            return layout->layout;
    }
    const auto layouts = project.layouts().all();
    return layouts && !layouts->empty() ? std::optional(layouts->front().layout) : std::nullopt;
}

TaskDraft draftOfTask(Project &project, const TaskRecord &task, const std::vector<TaskRecord> &all)
{
    TaskDraft draft;
    draft.task = task;
    for (const TaskRecord &each : all)
        if (each.id != task.id)
            draft.taken << QString::fromStdString(each.name);
    const std::vector<std::string> usual{
        "gate_time",        "best_lap",        "mean_lap",      "laps",           "gates_passed",
        "cross_track_mean", "cross_track_rms", "cross_track_max", "path_completed", "zone_breaches",
        "zone_time",        "zone_depth",      "duration",      "max_speed",      "mean_speed",
        "stops",            "standing_time",   "straightness",  "path_length",    "spikes",
        "limit_breaches"};
    draft.metrics = usual;
    for (const std::string &name : project.analyses().metricNames().value_or(std::vector<std::string>()))
        if (std::ranges::find(usual, name) == usual.end())
            draft.metrics.push_back(name);
    if (task.id != 0)
        draft.scoring = project.tasks().scoring(task.id).value_or(std::vector<Criterion>());
    draft.layout = layoutForTasks(project);
    return draft;
}

} // namespace odo
