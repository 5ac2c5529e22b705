// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace odo {

/// Numbered images that are the frames of one video, by their numbers.
struct ImageSeries
{
    std::vector<std::filesystem::path> files;
    std::vector<std::int64_t> numbers; ///< strictly increasing
};

/// Whether the last part of a path is a pattern of numbered files: "a_%06d.png", "%d.jpg".
bool isImagePattern(const std::filesystem::path &path);

/// The files that a pattern or a folder of one series means: PNG, JPEG, TIFF, BMP and WebP by their endings;
/// others in a folder do not count. Lists the folder and opens nothing. Any thread. Errors: no such folder,
/// fewer than two images, several series in the folder, two images with one number.
Result<ImageSeries> imagesOf(const std::filesystem::path &patternOrFolder);

/// When frames with these numbers were taken at a rate of the numbers: one that is missing leaves its gap.
std::vector<Nanoseconds> timesOfNumbers(const std::vector<std::int64_t> &numbers, double framesPerSecond);

/// A sentence on missing numbers, empty where none is; the Error where so many are that they cannot count
/// frames.
Result<Message> missingImages(const std::filesystem::path &patternOrFolder,
                              const std::vector<std::int64_t> &numbers);

} // namespace odo
