// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/trajectory/scoring.h"

#include <vector>

namespace odo {

/// The tasks of the demo's trials (demoTrials, by name), laid where its robots drive: a straight line with start
/// and finish, laps of a circle, a figure eight, and a square with stops.
std::vector<TaskRecord> demoTasks();
/// How one of them is scored: by its time, by how well its path is kept, and a point off for each spike.
std::vector<Criterion> demoScoring(const Task &task);

} // namespace odo
