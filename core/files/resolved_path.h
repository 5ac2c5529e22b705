// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace odo {

/// A path without links, dots and doubled slashes; nothing where it leads nowhere. Never throws on what the disk says.
std::optional<std::filesystem::path> realPath(const std::filesystem::path &file);

/// Where a file that may not exist yet would be written, all links followed, those that lead nowhere too.
struct ResolvedPath
{
    std::filesystem::path real;               ///< its folder exists
    std::vector<std::filesystem::path> named; ///< how it was called: the path given, and what each link said; absolute
};

/// Errors: WrongCall without a file name, NotFound without its folder, Io with the system's reason. Any thread.
Result<ResolvedPath> resolved(const std::filesystem::path &file);

} // namespace odo
