// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

struct sqlite3_file;

namespace odo {

/// The bytes of a database file, read through SQLite's own file layer. No other way is safe while this process has
/// the file open: closing any descriptor of a file drops all locks of the process on it (POSIX, fcntl(2)), unless
/// SQLite does it, which keeps the descriptor until its locks are gone (https://www.sqlite.org/howtocorrupt.html,
/// section 2.2). Takes no lock itself, so what another process writes meanwhile may be read half. Any thread.
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
    /// False where the disk does not give all of them; those behind the file's end are zeros, and count as given.
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
