// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/job.h"

#include <filesystem>
#include <string>

namespace odo {

/// Makes a project with the set-up of another one: cameras with their lens in force, marker layouts, robots, and the tasks
/// that are in use with how they are scored. Without people and trials; cameras are registered anew where they stand, and the
/// pictures of their calibration stay with the other project. Gives the file. Any thread. Errors: those of Project::open and
/// Project::create, and Cancelled; what was begun is removed then, and a file that was there stays.
Result<std::filesystem::path> makeProjectLike(const std::filesystem::path &original, const std::filesystem::path &file,
                                              const std::string &title, const JobControl &control);

} // namespace odo
