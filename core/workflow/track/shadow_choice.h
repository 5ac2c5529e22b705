// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/track/robot_names.h"

namespace odo {

/// All views of a trial, tracked, with their robots' names settled.
struct SettledViews
{
    std::vector<TrackedView> views;
    std::vector<NameDoubt> doubts;
};

/// trackViews and settleNames. On a plain floor a deep shadow and a dark side of a robot look alike in a
/// single frame, but not in a whole run: a shadow does not turn with the robot, and has no height. Where much
/// of the robots may be deep shadow, everything is tracked once or twice more, for darker shadows, and what
/// solids explain best is kept. Touches no project. Errors: those of both.
Result<SettledViews> trackAndSettle(const std::vector<RegisteredView> &views,
                                    const std::vector<RobotRecord> &robots, const JobControl &control,
                                    const std::vector<PointedOutRobot> &pointedOut = {});

} // namespace odo
