// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <memory>

namespace odo {

class Project;

struct StoredExampleOptions
{
    int frames = 30;
    int widthPx = 320, heightPx = 180;
};

/// Makes "example.odo" in a folder, out of exampleScene: class 9B with the teams Falcon and Heron, cameras A
/// and B calibrated and registered on the layout "floor", the robots "Red 2" and "Blue 1", and three trials:
/// "Trial 1" (Falcon, one robot, analysed, with videos), "Trial 2" (Heron, two robots, analysed, the same
/// videos) and "Trial 3" (no team, not tracked, its videos are missing). Trial 1 is the newest.
Result<std::filesystem::path> storeExample(const std::filesystem::path &folder,
                                           const StoredExampleOptions &options = {});

/// The same, opened; ends the test where it cannot be had.
std::unique_ptr<Project> openStoredExample(const std::filesystem::path &folder,
                                           const StoredExampleOptions &options = {});

} // namespace odo
