// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/chained_registration.h"

#include <filesystem>
#include <vector>

namespace odo {

/// Reads where two cameras see points of the floor: columns label,u,v,through_u,through_v in luma pixels.
/// Refuses, naming the line: labels that are empty or there twice, and numbers that are none. Any thread.
Result<std::vector<SharedPoint>> readSharedPointsCsv(const std::filesystem::path &file);

} // namespace odo
