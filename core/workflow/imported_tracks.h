// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <vector>

namespace odo {

class Project;

/// Where the tracks came from that another program measured of a trial's robots, without their samples, in the robots' order; none of a
/// trial that has recordings. On the project's thread.
Result<std::vector<ImportedTrack>> importedTracksOf(Project &project, const TrialRecord &trial);

} // namespace odo
