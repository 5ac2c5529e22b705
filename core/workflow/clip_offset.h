// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/trajectory/clip_evidence.h"
#include "core/workflow/registered_view.h"

namespace odo {

/// Reads all views once, tracks the robots where two views or more are registered and measures the light, and finds for
/// each view but the first how its clock lies against the first view's (findClipOffset): Undetermined, with the reason,
/// where neither the motion nor a flash tells. Touches no project. Errors: a video that cannot be read; cancelled.
Result<std::vector<Result<FoundOffset>>> findClipOffsets(const std::vector<RegisteredView> &views,
                                                         const std::vector<RobotRecord> &robots,
                                                         const JobControl &control);

} // namespace odo
