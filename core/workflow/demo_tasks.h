// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <vector>

namespace odo {

/// The tasks of the demo's trials (demoTrials, by name), laid where its robots drive: a straight line with start
/// and finish, laps of a circle, a figure eight, and a square with stops.
std::vector<TaskRecord> demoTasks();

} // namespace odo
