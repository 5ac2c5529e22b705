// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/task.h"
#include "core/base/error.h"

#include <filesystem>

namespace odo {

/// Reads a task from a JSON file (or the same in YAML), lengths in mm, all parts optional:
///   {"template": "circle",
///    "gates": [{"name": "line", "role": "start_finish", "from_mm": [x, y], "to_mm": [x, y]}],
///    "reference_path": {"points_mm": [[x, y], ...], "closed": true},
///    "limits": {"speed_mm_s": 3000, "acceleration_mm_s2": 15000}}
/// A reference path may instead be one of {"circle": {"centre_mm", "radius_mm"}}, {"figure_eight":
/// {"centre_mm", "half_width_mm", "half_height_mm"}} and {"slalom": {"from_mm", "to_mm", "poles",
/// "swing_mm"}}. At most 1 MiB. Errors name file and line; keys that are not known are refused.
Result<Task> readTaskFile(const std::filesystem::path &file);

} // namespace odo
