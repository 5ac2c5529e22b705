// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

struct LabelledPoint
{
    std::string label;
    double x = 0, y = 0; ///< in the file's unit
};

/// Reads a CSV file with a column of labels and two of numbers, whose names are given. Refuses, naming the
/// line: labels that are empty or there twice, numbers that are none; and a file without points.
Result<std::vector<LabelledPoint>> readLabelledPoints(const std::filesystem::path &file,
                                                      const std::vector<std::string> &columns);

} // namespace odo
