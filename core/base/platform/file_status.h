// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/file_system.h"

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>

/// What the system knows of a file or folder without opening it. Any thread.
namespace odo {

/// Which file a path leads to: the same for all of its names.
struct FileIdentity
{
    std::uint64_t device = 0, inode = 0;
    friend auto operator<=>(const FileIdentity &, const FileIdentity &) = default;
};

struct FileStatus
{
    files::Kind kind = files::Kind::Missing;
    FileIdentity identity;
    std::int64_t bytes = 0;
    std::int64_t modifiedNs = 0; ///< when it was written to, since 1970
    std::uint64_t names = 0;     ///< how many it has; none of one that was deleted while it is open
    unsigned permissions = 0;    ///< who may do what, as FileHandle::setPermissions takes it
    bool isOwn = false;          ///< this user's
};
/// Links are followed.
SystemResult<FileStatus> statusOf(const std::filesystem::path &path);
/// Of what is there itself, which may be a link.
SystemResult<FileStatus> statusOfItself(const std::filesystem::path &path);

/// Links are followed; nothing where there is no file.
std::optional<FileIdentity> identityOf(const std::filesystem::path &file);
/// Where a file that this process has open is now; nothing if it was deleted.
std::optional<std::filesystem::path> pathOfOpenFile(const FileIdentity &file);

enum class FileAccess { Read, Write, Both };
/// Why this user may not do so with a file or folder; empty: may.
std::error_code checkAccess(const std::filesystem::path &path, FileAccess access);

} // namespace odo
