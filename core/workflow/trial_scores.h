// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/trajectory/scoring.h"

#include <optional>
#include <vector>

namespace odo {

class Project;

/// By which a score is known among the metrics of trials; a higher one is better.
constexpr const char *scoreMetric = "score";

/// What a robot's run in a trial of a scored task is worth.
struct TrialScore
{
    RecordId trial = 0, robot = 0, task = 0;
    /// nullopt: its newest analysis was measured by another task than the trial has, or by it as it was
    /// before it was changed.
    std::optional<Score> score;
};

/// Of each robot in the trials from one moment to another (both belong to them) whose task is scored, by its
/// newest analysis. Computed from what is stored, so that another scoring counts at once. On the project's
/// thread.
Result<std::vector<TrialScore>> trialScores(Project &project, Instant from, Instant to);

/// The same as figures with the name scoreMetric; runs without a score are left out.
Result<std::vector<TrialFigure>> scoreFigures(Project &project, Instant from, Instant to);

/// A figure of the newest analysis of each robot, of all trials: a metric by its name, or the score by
/// scoreMetric.
Result<std::vector<TrialFigure>> figuresOf(Project &project, const std::string &metric);

} // namespace odo
