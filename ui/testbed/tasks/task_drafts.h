// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "ui/testbed/tasks/task_editor.h"

#include <optional>
#include <vector>

namespace odo {

class Project;

/// The marker layout of the cameras, for a task lies among their markers; else the first one that there is. Project's thread.
std::optional<MarkerLayout> layoutForTasks(Project &project);

/// What an editor of a task begins with. task: of the project, or a new one (id 0); all: those that there are. Project's thread.
TaskDraft draftOfTask(Project &project, const TaskRecord &task, const std::vector<TaskRecord> &all);

} // namespace odo
