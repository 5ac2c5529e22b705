// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/standings.h"
#include "ui/report/report_maker.h"

#include <memory>

namespace odo {

/// What the report of a class says: immutable values.
struct ClassContent
{
    ClassReportSettings settings; ///< with task and metric chosen
    Standings standings;
    int leftOut = 0; ///< trials of the task that were measured by another course
    int trials = 0;  ///< of the class in the task, those without a figure too
};
using ClassContentPtr = std::shared_ptr<const ClassContent>;

/// Reads the standings of a class. On the project's thread. Errors: NotFound, with the classes there are, for a
/// class or a task that is not there, or where no run of the class has the figure; those of the repositories.
Result<ClassContentPtr> readClassContent(Project &project, const ClassReportSettings &settings);

} // namespace odo
