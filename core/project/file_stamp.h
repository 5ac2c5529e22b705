// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

struct sqlite3;

namespace odo {

/// A database file's size and time of its last change, beside SQLite's own account of what it wrote to file and log. A file that
/// changed while the account did not was written to past SQLite, as by copying another file over it: what this program knows
/// of it is then of no use, and what it would write would damage the other one.
struct FileStamp
{
    std::int64_t size = 0, modifiedNs = 0;
    /// Of the log's index (https://www.sqlite.org/walformat.html, section 2.1): its header, and how much of the log is written back.
    std::array<std::uint32_t, 14> account{};

    bool isOverwrittenSince(const FileStamp &before) const;
};

/// Of a database with a write-ahead log, from which something was read; on the connection's thread. nullopt where it has none.
std::optional<FileStamp> fileStamp(sqlite3 *database, const std::filesystem::path &file);

} // namespace odo
