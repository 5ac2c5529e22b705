// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/repositories.h"

#include <span>
#include <string>
#include <vector>

namespace odo {

/// Whether a trial belongs to a class and to a task (empty: to any) and is not in the bin. Pure.
bool countsIn(const TrialRecord &trial, const std::string &className, const std::string &task);

/// Trials whose figures can be compared, in their order; they must outlive it.
struct CountedTrials
{
    std::vector<const TrialRecord *> trials;
    int leftOut = 0; ///< that belong to the task, and were measured by another course than it has now
};
/// Those that count in a class and a task (countsIn), without those that were measured otherwise; of any task
/// none is left out for that. otherwise: in order of their ids. Pure.
CountedTrials countedTrials(std::span<const TrialRecord *const> trials, const std::string &className,
                            const std::string &task, const std::vector<OtherwiseMeasured> &otherwise);
CountedTrials countedTrials(const std::vector<TrialRecord> &trials, const std::string &className,
                            const std::string &task, const std::vector<OtherwiseMeasured> &otherwise);

} // namespace odo
