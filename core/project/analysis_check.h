// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/project/project.h"

#include <vector>

namespace odo {

struct ProjectConnection;

/// Whether every trial's newest analyses are what they were when they were made: by their digests, and by computing their
/// metrics again from the stored positions. isThorough: of all trials; else of those without digests or where one differs. Of
/// those the measurements are read as well. Reports the part of the trials. Cancelled.
Result<void> checkAnalyses(Project &project, const ProjectConnection &connection, bool isThorough, const JobControl &control,
                           std::vector<ProjectProblem> &problems);

} // namespace odo
