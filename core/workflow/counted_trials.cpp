// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/counted_trials.h"

#include <algorithm>

namespace odo {

bool countsIn(const TrialRecord &trial, const std::string &className, const std::string &task)
{
    return !trial.binned && (className.empty() || trial.className == className) &&
           (task.empty() || trial.task == task);
}

CountedTrials countedTrials(std::span<const TrialRecord *const> trials, const std::string &className,
                            const std::string &task, const std::vector<OtherwiseMeasured> &otherwise)
{
    CountedTrials counted;
    for (const TrialRecord *trial : trials) {
        if (!countsIn(*trial, className, task))
            continue;
        if (!task.empty() && std::ranges::binary_search(otherwise, trial->id, {}, &OtherwiseMeasured::trial))
            ++counted.leftOut;
        else
            counted.trials.push_back(trial);
    }
    return counted;
}

CountedTrials countedTrials(const std::vector<TrialRecord> &trials, const std::string &className,
                            const std::string &task, const std::vector<OtherwiseMeasured> &otherwise)
{
    std::vector<const TrialRecord *> all;
    for (const TrialRecord &trial : trials)
        all.push_back(&trial);
    return countedTrials(all, className, task, otherwise);
}

} // namespace odo
