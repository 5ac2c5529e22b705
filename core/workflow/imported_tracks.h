// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <vector>

namespace odo {

class Project;

/// The tracks that another program measured of a trial's robots, in the robots' order; none of a trial that has recordings. On the
/// project's thread.
Result<std::vector<ImportedTrack>> importedTracksOf(Project &project, const TrialRecord &trial);

} // namespace odo
