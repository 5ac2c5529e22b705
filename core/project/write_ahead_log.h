// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/temporary.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_file;

namespace odo {

/// Ties a write-ahead log to its database. SQLite applies whatever log it finds beside a file, also one that
/// a killed program left beside another file of that name. Each transaction that changes rows therefore
/// writes a mark into the file's header, made from the mark before it and a random number. So the log holds
/// the header of each state that it leads to, and its first mark shows which state it begins with. 0: not
/// marked yet.
///
/// It is stored as the "suggested cache size" (https://www.sqlite.org/fileformat.html, section 1.3.13), which
/// SQLite keeps and copies but does not need; each connection sets its own. The header's change counter does
/// not serve: in WAL mode a connection writes the same count again and again.
using LogMark = std::uint32_t;

/// For a database that begins a history of its own.
LogMark newLogMark();
/// For a transaction on a database with that mark.
LogMark nextLogMark(LogMark before);

/// Whether the log beside a project file belongs to it, before SQLite applies it. Unavailable where it does
/// not. A log without marks, of an older Odograph or another program, counts as belonging to it. Other
/// processes may write meanwhile. Changes nothing. Any thread.
Result<void> checkLog(const std::filesystem::path &file);

/// Whether a write-ahead log with anything in it is beside a database; beside the file itself, where the
/// path is a link.
bool hasLog(const std::filesystem::path &file);

/// A database and its log, copied into a folder of their own below the one for temporary files, which goes
/// with this object: for a folder that cannot be written to, where SQLite cannot make the index that it needs
/// to read a log.
class LogCopy
{
public:
    /// Errors: those of TemporaryFolder, Io where they cannot be read or the copy cannot be written,
    /// Unavailable where another program keeps changing them.
    static Result<std::unique_ptr<LogCopy>> make(const std::filesystem::path &file);

    std::filesystem::path file() const { return m_folder->path() / "project.odo"; }

private:
    explicit LogCopy(std::unique_ptr<TemporaryFolder> folder) : m_folder(std::move(folder)) {}
    Result<void> fill(const std::filesystem::path &file) const;

    const std::unique_ptr<TemporaryFolder> m_folder;
};

/// What SQLite may leave beside a database, by what follows the database's own name: its rollback journal,
/// its write-ahead log, and the index of that log (https://www.sqlite.org/tempfiles.html). Where the database
/// goes they go, or SQLite would apply them to another one.
inline constexpr const char *journalSuffix = "-journal", *logSuffix = "-wal", *logIndexSuffix = "-shm";
inline constexpr std::array sideFileSuffixes{journalSuffix, logSuffix, logIndexSuffix};

/// The file whose name is that one's with something behind it.
inline std::filesystem::path besideFile(const std::filesystem::path &file, const std::string &suffix)
{
    return file.string() + suffix;
}

/// A database file's size and time of its last change, beside SQLite's own account of what it wrote to file
/// and log. A file that changed while the account did not was written to past SQLite, as by copying another
/// file over it: what this program knows of it is then of no use, and what it would write would damage the
/// other one.
struct FileStamp
{
    std::int64_t size = 0, modifiedNs = 0;
    /// Of the log's index (https://www.sqlite.org/walformat.html, section 2.1): its header, and how much of
    /// the log is written back.
    std::array<std::uint32_t, 14> account{};

    bool isOverwrittenSince(const FileStamp &before) const;
};

/// Of a database with a write-ahead log, from which something was read; on the connection's thread. nullopt
/// where it has none.
std::optional<FileStamp> fileStamp(sqlite3 *database, const std::filesystem::path &file);

/// The bytes of a database file, read through SQLite's own file layer. No other way is safe while this
/// process has the file open: closing any descriptor of a file drops all locks of the process on it (POSIX,
/// fcntl(2)), unless SQLite does it, which keeps the descriptor until its locks are gone
/// (https://www.sqlite.org/howtocorrupt.html, section 2.2). Takes no lock itself, so what another process
/// writes meanwhile may be read half. Any thread.
class DatabaseBytes
{
public:
    explicit DatabaseBytes(const std::filesystem::path &file);
    ~DatabaseBytes();
    DatabaseBytes(const DatabaseBytes &) = delete;
    DatabaseBytes &operator=(const DatabaseBytes &) = delete;

    bool isOpen() const;
    /// 0 where the system does not say.
    std::uintmax_t size() const;
    /// False where the disk does not give all of them; those behind the file's end are zeros, and count as
    /// given.
    bool read(std::span<std::byte> into, std::uintmax_t offset) const;

private:
    const char *m_name = nullptr; ///< SQLite's copy of the path, which it keeps while the file is open
    std::vector<std::max_align_t> m_memory;
    sqlite3_file *m_file = nullptr;
};

/// With which a database file begins: https://www.sqlite.org/fileformat.html, section 1.3.
using DatabaseHeader = std::array<std::byte, 100>;

/// A number as the file and its log hold them.
std::uint32_t bigEndian(std::span<const std::byte> bytes, std::size_t offset);

} // namespace odo
