// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/exchange/trial_table.h"

#include <string>
#include <vector>

namespace odo {

class Project;

/// Which trials and metrics a table has. What is empty chooses all.
struct TrialTableChoice
{
    std::string className, task, team;
    std::vector<std::string> metrics; ///< in this order; scoreMetric is the score
};

/// The newest analysis of each robot in the trials that are not in the bin, the oldest trial first, with the
/// scores of tasks that are scored. A metric of two units has two columns. On the project's thread. Errors:
/// NotFound for a class, task, team or metric that the project doesn't have.
Result<ResultTable> readTrialTable(Project &project, const TrialTableChoice &choice);

} // namespace odo
