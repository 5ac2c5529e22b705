// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/trajectory/clip_synchronisation.h"
#include "core/workflow/registered_view.h"

namespace odo {

/// Tracks the robots in two registered views and finds the offset between the clips from the motion of the one that
/// moved most. Undetermined, with the reason, where a view is not registered, no robot is known, or the motion does not
/// tell. Touches no project.
Result<ClipOffset> clipOffsetFromMotion(const RegisteredView &first, const RegisteredView &second,
                                        const std::vector<RobotRecord> &robots, const JobControl &control);

} // namespace odo
