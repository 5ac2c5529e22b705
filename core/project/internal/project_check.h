// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/project/project.h"

namespace odo {

struct ProjectConnection;

/// All that Project::check looks at, in the order: database, references, analyses, files.
Result<std::vector<ProjectProblem>> checkProject(Project &project, ProjectConnection &connection,
                                                 bool withHashes, const JobControl &control);

} // namespace odo
