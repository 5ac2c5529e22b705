// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/files/output_guard.h"

#include <filesystem>

namespace odo {

/// Reads a marker layout: columns label,x_mm,y_mm. The layout has no name yet. Errors, with file and line: no
/// markers, a label that is empty or there twice, a value that is no finite number. Any thread.
Result<MarkerLayout> readLayoutCsv(const std::filesystem::path &file);

/// Writes what readLayoutCsv reads, such that the same numbers are read back.
Result<void> writeLayoutCsv(const OutputTarget &target, const MarkerLayout &layout);

} // namespace odo
