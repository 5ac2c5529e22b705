// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace odo {
class Project;
}

namespace odo::test {

/// Makes "slalom.odo" in a folder: class 9B with the teams Falcon, Heron and Otter, the task "Slalom", and no
/// run yet. Ends the test where it cannot be had.
std::unique_ptr<Project> makeSlalomLesson(const std::filesystem::path &folder);

/// Adds a run of a team that took so long, ±0.05 s, a minute after the one before: a trial "Run 1", "Run 2",
/// … with an analysed track whose verdict is accepted.
void addSlalomRun(Project &project, const std::string &team, double seconds);

} // namespace odo::test
