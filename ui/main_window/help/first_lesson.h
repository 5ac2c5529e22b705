// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window/help/lesson.h"

namespace odo {

class ProjectPages;

/// Five minutes on the demo project, from playing a run to finding it again. The pages must outlive the lesson.
std::vector<LessonStep> firstLesson(const ProjectPages &pages);

} // namespace odo
