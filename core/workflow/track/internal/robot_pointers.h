// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/track/track_job.h"
#include "core/workflow/trial_sources.h"

#include <optional>
#include <vector>

namespace odo {

/// The recording's frame that is nearest to a time of the trial, and not far from it.
std::optional<std::int64_t> frameAt(const RecordingRecord &recording, double timeS);

/// What is pointed out in a trial, with the new marks replacing those of the same robot and view; nothing
/// else is changed. robots: those tracked. Errors: a robot or view that the trial has not, a time without a
/// frame, a position outside the frame. Project's thread.
Result<std::vector<PointedOutRobot>> pointedOutRobots(Project &project, const TrialRecord &trial,
                                                      const std::vector<RegisteredView> &views,
                                                      const std::vector<RobotRecord> &robots,
                                                      const std::vector<RobotPointer> &pointers);

} // namespace odo
