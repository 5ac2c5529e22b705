// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/platform/file_status.h"

#include <cstdint>
#include <filesystem>
#include <span>

namespace odo {

/// A file or folder that this process holds open as long as the object lives. Programs that it starts do not
/// inherit it, and nothing waits for the other end of a pipe. All errors are the system's. One thread at a
/// time. Files for people are written through core/files; what tests/files/tst_one_way knows may make files
/// by this.
class FileHandle
{
public:
    enum class Links { Followed, Refused };                          ///< in place of the file itself
    enum class Permissions { OwnerAlone, OwnerWrites, UserDefault }; ///< of a new file
    enum class Use { Write, ReadAndWrite };
    enum class Lock { Shared, Exclusive };

    FileHandle() = default; ///< of nothing, on which all calls fail
    ~FileHandle() { close(); }
    FileHandle(FileHandle &&other) noexcept;
    FileHandle &operator=(FileHandle &&other) noexcept;

    static SystemResult<FileHandle> openToRead(const std::filesystem::path &file, Links links);
    static SystemResult<FileHandle> openFolder(const std::filesystem::path &folder, Links links);
    /// A new file, to read and to write; std::errc::file_exists where anything has that name.
    static SystemResult<FileHandle> create(const std::filesystem::path &file, Permissions permissions);
    /// What is there, with what it holds, or a new file. Never through a link.
    static SystemResult<FileHandle> openOrCreate(const std::filesystem::path &file, Use use,
                                                 Permissions permissions);

    bool isOpen() const { return m_number >= 0; }
    /// For libraries that write to a file that is open; it belongs to this object. Below zero: of nothing.
    int number() const { return m_number; }
    SystemResult<FileStatus> status() const;
    /// Whether the path leads to this very file, and not through a link: somebody may have renamed or removed
    /// it, and another one may have its name.
    bool isAt(const std::filesystem::path &path) const;

    /// From the file's beginning; how many bytes that gave, fewer at its end.
    SystemResult<std::size_t> readStart(std::span<char> into) const;
    /// All of it, behind what was written before.
    std::error_code write(std::span<const char> bytes) const;
    /// Where the next write goes; whence as of std::fseek.
    SystemResult<std::int64_t> seek(std::int64_t offset, int whence) const;
    /// Removes all bytes.
    std::error_code clear() const;
    /// All that was written is on the disk.
    std::error_code sync() const;
    /// Likewise, but without the times of the file.
    std::error_code syncData() const;
    std::error_code setPermissions(unsigned permissions) const;

    /// Locks it against other handles that lock it, of this program too, until the handle is closed, however
    /// the program ends. Who does not ask for a lock is not kept from anything. Waits. A failure: the file
    /// system knows no locks.
    std::error_code lock(Lock kind) const;
    /// The same without waiting: std::errc::operation_would_block where another handle has it.
    std::error_code tryLock(Lock kind) const;
    void unlock() const;

private:
    explicit FileHandle(int number) : m_number(number) {}
    static SystemResult<FileHandle> opened(int number);
    void close();

    int m_number = -1;
};

} // namespace odo
