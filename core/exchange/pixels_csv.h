// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"

#include <filesystem>
#include <vector>

namespace odo {

/// Reads where a camera sees markers: columns label,u,v in luma pixels (0,0 is the centre of the top-left
/// one). Errors as readLayoutCsv. Any thread.
Result<std::vector<MarkerPixel>> readPixelsCsv(const std::filesystem::path &file);

} // namespace odo
