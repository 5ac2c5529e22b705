// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/trajectory/name_assignment.h"
#include "core/workflow/track/view_tracking.h"

#include <vector>

namespace odo {

/// What helps to identify a robot: a colour only if one with chroma was given.
NamedRobot namedRobot(const RobotRecord &robot);

/// Settles, over all views of a trial, which of the tracked series is which robot (assignNames), before
/// anything is analysed or stored, and which tracked object is a robot of any look. The views' offsets must
/// be known. Gives when the identity was ambiguous, by the robots' numbers. pointedOut: of the trial.
/// InvalidInput: nothing was tracked where a robot was pointed out.
Result<std::vector<NameAmbiguity>> settleNames(const std::vector<RegisteredView> &views,
                                               const std::vector<RobotRecord> &robots,
                                               std::vector<TrackedView> &tracked,
                                               const std::vector<PointedOutRobot> &pointedOut = {});

/// The same as they are stored: of each robot its own.
std::vector<std::vector<AmbiguousName>> ambiguousNamesOf(const std::vector<NameAmbiguity> &ambiguities,
                                                         const std::vector<RobotRecord> &robots);

/// Their total duration. They do not overlap.
double ambiguousSeconds(const std::vector<AmbiguousName> &ambiguities);

/// All views of a trial, tracked, with their robots' names settled.
struct SettledViews
{
    std::vector<TrackedView> views;
    std::vector<NameAmbiguity> ambiguities;
};

/// trackViews and settleNames. A tinted or deep shadow and a side of a robot look alike in a single frame,
/// but not in a whole run: a shadow does not turn with the robot, and has no height. Where
/// shadows connect what was followed, everything is tracked once more as if they connected parts of one body;
/// where much of the robots may be tinted shadow, once more for such shadows; where it may be deep shadow,
/// once or twice more for darker ones. What solids explain best is kept. Touches no project. Errors: those of
/// both.
Result<SettledViews> trackAndSettle(const std::vector<RegisteredView> &views,
                                    const std::vector<RobotRecord> &robots, const JobControl &control,
                                    const std::vector<PointedOutRobot> &pointedOut = {});

} // namespace odo
