// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>

namespace odo {

/// What SQLite may leave beside a database, by what follows the database's own name: its rollback journal, its write-ahead log, and the
/// index of that log (https://www.sqlite.org/tempfiles.html). Where the database goes they go, or SQLite would apply them to another one.
inline constexpr const char *journalSuffix = "-journal", *logSuffix = "-wal", *logIndexSuffix = "-shm";
inline constexpr std::array sideFileSuffixes{journalSuffix, logSuffix, logIndexSuffix};

/// The file whose name is that one's with something behind it.
inline std::filesystem::path besideFile(const std::filesystem::path &file, const std::string &suffix)
{
    return file.string() + suffix;
}

} // namespace odo
