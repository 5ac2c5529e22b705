// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/units.h"

#include <filesystem>
#include <vector>

namespace odo {

/// Writes images as the frames of one video (Matroska) without loss: JPEG that is upright bit for bit, all
/// else as readImage gives it, turned as it says, by FFV1. times: of each, since the first, strictly
/// increasing; the file's stamps are those, of JPEG rounded to milliseconds. claimed: an empty file. One
/// image in memory at a time. Any thread. Errors, naming the image: those of readImage, another size or
/// layout than the first has, fewer than two images; Io; Cancelled.
Result<void> writeImageVideo(const std::vector<std::filesystem::path> &images,
                             const std::vector<Nanoseconds> &times, const std::filesystem::path &claimed,
                             const JobControl &control);

} // namespace odo
