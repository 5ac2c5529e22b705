// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>

namespace odo {

class Project;

/// Copies an open project whose file is no longer in its place (Project::isInPlace) to "<name> (rescued).odo" beside where it
/// was, or where its file was moved to when that folder is gone, or in the home folder; numbered where a file of that name
/// is. Gives the new file. On the project's thread.
Result<std::filesystem::path> rescueProject(const Project &project);

} // namespace odo
