// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "tests/benchmark/metrics.h"

#include <filesystem>

namespace odo::test {

/// What it costs to follow one and six robots of any look by their silhouettes, beside OpenCV's subtraction
/// of the background (MOG2) on the same frames and beside decoding; each ratio is taken within its round, and
/// the median of the rounds counts. The clips, H.264 of 8 Mbit/s, are rendered into a folder; those that are
/// there are used again.
Result<std::vector<Measurement>> measureLooks(const std::filesystem::path &folder, double durationS,
                                              int rounds);

} // namespace odo::test
