// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <functional>
#include <optional>
#include <vector>

namespace odo {

/// A profile with the options that it was made with in the end.
struct TaskAnalysis
{
    Profile profile;
    AnalysisOptions options;
    /// empty, or why the task's limits were left out: "what: why; do this" from the why on
    Message doubt;
};

/// Makes a profile with the options it is given.
using MakeProfile = std::function<Result<Profile>(const AnalysisOptions &)>;

/// An analysis by a task, if there is one. Limits that refuse more than a fifth of what was measured are none
/// of this robot's: then it is made once more without them, and says so. As pure as `make`.
Result<TaskAnalysis> analyseByTask(const MakeProfile &make, const AnalysisOptions &options,
                                   const std::optional<TaskRecord> &task);

} // namespace odo
