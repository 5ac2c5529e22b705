// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/registered_view.h"
#include "core/workflow/track_job.h"

#include <vector>

namespace odo {

class Project;

/// What is pointed out in a trial, with what a person says now in place of what was said of the same robot and view before; nothing else is changed.
/// robots: those tracked. Errors: a robot or view that the trial has not, a robot that is found by its colour, a time without a picture, a place
/// outside the picture. Project's thread.
Result<std::vector<PointedOutRobot>> pointedOutRobots(Project &project, const TrialRecord &trial, const std::vector<RegisteredView> &views,
                                                      const std::vector<RobotRecord> &robots, const std::vector<RobotPointer> &pointers);

} // namespace odo
