// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace odo {

class Project;

/// A figure in the middle of a class.
struct ClassFigure
{
    double median = 0;
    int runs = 0; ///< each robot's in each trial
};

/// The median of each metric over the runs of a class in a task, by the metrics' names; those that no run has
/// are not in it. Of trials that count there (countedTrials). On the project's thread. Errors: those of the
/// repositories.
Result<std::map<std::string, ClassFigure>> classFigures(Project &project, const std::string &className,
                                                        const std::string &task,
                                                        const std::vector<std::string> &metrics);

} // namespace odo
