// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <string>

namespace odo {

class Project;

/// Adds a trial of the same recordings, or of the same imported tracks, to analyse it in another way: with
/// the team, task, robots, date, notes, tags, range and synchronisation of the original, its newest
/// observations, manual overrides, marks of robots and known truth. It has no analysis yet, so no run counts
/// twice. Videos are shared, not copied. It cannot be undone. name: empty: "NAME copy", or "NAME copy 2"
/// where that is taken. On the project's thread. Errors: NotFound; AlreadyExists for a name that is taken;
/// InvalidInput for a trial that is being recorded.
Result<TrialRecord> copyTrial(Project &project, const std::string &trial, const std::string &name = {});

} // namespace odo
