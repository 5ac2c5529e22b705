// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <filesystem>
#include <vector>

namespace odo {

/// The files in a project's media folder that no recording, lens calibration or floor registration refers to, by whatever name or link: what a
/// killed program left, or a person put there. In the order of their names. Without what a living program is writing
/// (ClaimedFile). Looks at the disk. Errors: those of the repositories; Io where the folder cannot be read.
Result<std::vector<std::filesystem::path>> strayMedia(Project &project);

/// For Project::check: a problem for each, or why it cannot be told.
void addStrayMedia(Project &project, std::vector<ProjectProblem> &problems);

/// Removes a stray file. False, and it stays, where it is none, or a living program is writing it. Error Io.
Result<bool> removeStray(Project &project, const std::filesystem::path &file);

} // namespace odo
