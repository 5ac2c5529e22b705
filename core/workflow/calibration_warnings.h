// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <chrono>
#include <string>
#include <vector>

namespace odo {

class Project;

/// Whole sentences on what may be wrong with a camera's calibration in force, each with what to do; empty: nothing.
/// Old: intrinsics or registration made longer than oldAfter before now. Overtaken: registered with older intrinsics
/// than the newest. Another size: the newest recording is of other pictures than the intrinsics. Never calibrated.
/// A camera that is not registered has no warning of a registration. Project's thread.
Result<std::vector<std::string>> calibrationWarnings(Project &project, const CameraRecord &camera, Instant now,
                                                     std::chrono::days oldAfter = std::chrono::days(90));

} // namespace odo
