// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <vector>

namespace odo {

struct ProjectConnection;

/// Values that are stored beside what they follow from, and shown: a trial's duration and synchronisation against its recordings or
/// imported tracks, the errors of the markers of each registration in force against its markers and pixels; and that what is in force of a
/// camera is its own. Reads the last frame times of a trial only, so thousands of trials are quick.
Result<void> checkDerivedFigures(Project &project, const ProjectConnection &connection, std::vector<ProjectProblem> &problems);

} // namespace odo
