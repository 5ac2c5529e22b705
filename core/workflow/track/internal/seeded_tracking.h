// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/robot_tracker.h"
#include "core/workflow/track/view_tracking.h"

#include <vector>

namespace odo {

/// Where a person marked robots in a frame of a view, by their numbers. Pure.
std::vector<RobotSeed> seedsIn(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                               std::int64_t frame);

/// Follows each robot from where a person marked it backwards as well, and puts what that gives in place of
/// what was followed there before: to where both are the same, to the mark before it, or to where it is lost
/// or merges with something.
/// What was followed instead goes to the other things. tracked: of all frames of the view, forwards, by the
/// same seeds. Errors: those of reading a video; cancelled.
Result<void> followBackwards(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                             const std::vector<TrackTarget> &targets, TrackedView &tracked,
                             const CancelToken &cancel);

} // namespace odo
