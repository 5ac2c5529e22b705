// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <optional>
#include <string>

namespace odo {

/// The newest of the backups that migrations have left beside a project ("<name>.odo.bak-<version>") in which SQLite finds nothing
/// wrong. Any thread; reads them wholly, up to the first that is sound.
std::optional<std::filesystem::path> soundBackupOf(const std::filesystem::path &project);

/// Whether a window has anything to show of a file: the header of a project, or a sound backup of it that can be restored. The errors are
/// those of Project::checkHeader.
Result<void> worthOpening(const std::filesystem::path &project);

/// To copy that backup by hand, as the advice of an error.
std::string adviceToCopy(const std::filesystem::path &backup);

/// Why a project cannot be used, with the advice to take the sound backup where there is one. Only where its content is at
/// fault (InvalidInput). The project is left as it is.
Error namingABackup(Error error, const std::filesystem::path &project);

} // namespace odo
