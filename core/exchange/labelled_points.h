// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/chained_registration.h"
#include "core/calibration/floor_reading.h"
#include "core/calibration/marker_layout.h"
#include "core/files/output_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// Reads a marker layout: columns label,x_mm,y_mm. The layout has no name yet. Errors, with file and line: no
/// markers, a label that is empty or there twice, a value that is no finite number. Any thread.
Result<MarkerLayout> readLayoutCsv(const std::filesystem::path &file);

/// Writes what readLayoutCsv reads, such that the same numbers are read back.
Result<void> writeLayoutCsv(const OutputTarget &target, const MarkerLayout &layout);

/// Reads where a camera sees markers: columns label,u,v in luma pixels (0,0 is the centre of the top-left
/// one). Errors as readLayoutCsv. Any thread.
Result<std::vector<MarkerPixel>> readPixelsCsv(const std::filesystem::path &file);

/// Points with their floor positions as a CSV table: label,u,v,x_mm,y_mm,sigma_x_mm,sigma_y_mm. The last four
/// cells are empty where a point has no position.
std::string locatedPointsCsv(const std::vector<LocatedPoint> &points);

/// Reads where two cameras see points of the floor: columns label,u,v,through_u,through_v in luma pixels.
/// Refuses, naming the line: labels that are empty or there twice, and numbers that are none. Any thread.
Result<std::vector<SharedPoint>> readSharedPointsCsv(const std::filesystem::path &file);

} // namespace odo
