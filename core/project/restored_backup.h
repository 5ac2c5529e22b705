// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>

namespace odo {

/// Which files a restored project was made of.
struct RestoredBackup
{
    std::filesystem::path backup;  ///< is still there
    std::filesystem::path damaged; ///< where the damaged file was kept, with what SQLite had beside it
};

/// Puts a copy of the newest sound backup in the place of a damaged project, which is kept as "<name>.odo.damaged" (or another name with a
/// number). Nothing is removed or written over, and killed at any moment the project's name has the one or the other
/// behind it (on a disk without links, the damaged file may only be left under its new name). The caller sees to it that nobody has the
/// project open. Any thread; reads and writes the whole file. Errors: NotFound without a sound backup; those of writing, and all is as before.
Result<RestoredBackup> restoreBackup(const std::filesystem::path &project);

} // namespace odo
