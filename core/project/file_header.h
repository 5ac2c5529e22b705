// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>

namespace odo {

/// Looks at the first bytes of a file, without a lock, and says in words why it is no project that can be opened:
/// missing, a folder, empty, another kind of file, another program's database, cut off, or written by a newer Odograph than
/// one that knows `newestVersion`. Says nothing false of a file that another process works on. Never changes anything.
Result<void> checkFileHeader(const std::filesystem::path &file, int newestVersion);

/// Whether the first bytes are those of a project, of any version and however damaged the rest is.
bool isProjectFile(const std::filesystem::path &file);

/// That there is such a file, which could be opened.
Result<void> checkIsFile(const std::filesystem::path &file);

} // namespace odo
