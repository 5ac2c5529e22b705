// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/project/project.h"

#include <vector>

namespace odo {

struct ProjectConnection;

/// Whether every trial's newest analyses are what they were when they were made: by their digests, and by
/// computing their metrics again from the stored positions. isThorough: of all trials; else of those without
/// digests or where one differs. Of those the measurements are read as well. Reports the part of the trials.
/// Cancelled.
Result<void> checkAnalyses(Project &project, const ProjectConnection &connection, bool isThorough,
                           const JobControl &control, std::vector<ProjectProblem> &problems);

/// Values that are stored beside what they follow from, and shown: a trial's duration and synchronisation
/// against its recordings or imported tracks, the errors of the markers of each registration in force against
/// its markers and pixels; and that what is in force of a camera is its own. Reads the last frame times of a
/// trial only, so thousands of trials are quick.
Result<void> checkDerivedMetrics(Project &project, const ProjectConnection &connection,
                                 std::vector<ProjectProblem> &problems);

} // namespace odo
