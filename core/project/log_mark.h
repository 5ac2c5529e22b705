// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <filesystem>

namespace odo {

/// Ties a write-ahead log to its database. SQLite applies whatever log it finds beside a file, also one that a killed program left
/// beside another file of that name. Each transaction that changes rows therefore writes a mark into the file's header, made from the mark
/// before it and a random number. So the log holds the header of each state that it leads to, and its first mark tells which state it begins
/// with. 0: not marked yet.
///
/// The place is the "suggested cache size" (https://www.sqlite.org/fileformat.html, section 1.3.13), which SQLite keeps and copies but
/// does not need; each connection sets its own. The header's change counter does not serve: in WAL mode a connection writes the same
/// count again and again.
using LogMark = std::uint32_t;

/// For a database that begins a history of its own.
LogMark newLogMark();
/// For a transaction on a database with that mark.
LogMark nextLogMark(LogMark before);

/// Whether the log beside a project file belongs to it, before SQLite applies it. Unavailable where it does not. A log without marks, of an
/// older Odograph or another program, counts as belonging to it. Other processes may write meanwhile. Changes nothing. Any thread.
Result<void> checkLog(const std::filesystem::path &file);

} // namespace odo
