// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/workflow/compare/trial_metrics.h"

namespace odo {

class Project;

/// The standings of a project, and what they leave out.
struct StandingsReading
{
    Standings standings; ///< with what was chosen
    int leftOut = 0;     ///< trials of the task that were measured by another course
    int bad = 0;         ///< trials that are left out for a bad verdict
    int trials = 0;      ///< of the class in the task, those without a metric too
};

/// Reads them. trials: all of the project. What is not chosen: the task that most trials have, and of metrics
/// the score where the task is scored, else the most informative one there is. Of all classes, without those
/// that are archived. On the project's thread. Errors: NotFound, with the classes there are, for a class or a
/// task that is not there; those of the repositories.
Result<StandingsReading> readStandings(Project &project, std::vector<TrialRecord> trials,
                                       StandingsChoice choice);

} // namespace odo
