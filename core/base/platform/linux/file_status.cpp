// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/file_status.h"

#include "core/base/platform/file_handle.h"

#include <cerrno>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace odo {

namespace {

files::Kind kindOfMode(mode_t mode)
{
    switch (mode & S_IFMT) {
    case S_IFREG:
        return files::Kind::File;
    case S_IFDIR:
        return files::Kind::Folder;
    case S_IFLNK:
        return files::Kind::Link;
    case S_IFIFO:
        return files::Kind::Pipe;
    case S_IFSOCK:
        return files::Kind::Socket;
    default:
        return files::Kind::Device;
    }
}

/// ask: stat() or one like it.
template <class Ask>
SystemResult<FileStatus> statusBy(const Ask &ask)
{
    struct stat found
    {
    };
    if (ask(&found) != 0)
        return tl::unexpected(std::error_code(errno, std::generic_category()));
    constexpr std::uint64_t nsOfSecond = 1'000'000'000; // without a sign: a time may be any number
    return FileStatus{
        kindOfMode(found.st_mode),
        {found.st_dev, found.st_ino},
        found.st_size,
        static_cast<std::int64_t>(static_cast<std::uint64_t>(found.st_mtim.tv_sec) * nsOfSecond +
                                  static_cast<std::uint64_t>(found.st_mtim.tv_nsec)),
        found.st_nlink,
        found.st_mode & 0777U,
        found.st_uid == ::geteuid()};
}

} // namespace

SystemResult<FileStatus> statusOf(const std::filesystem::path &path)
{
    return statusBy([&](struct stat *found) { return ::stat(path.c_str(), found); });
}

SystemResult<FileStatus> statusOfItself(const std::filesystem::path &path)
{
    return statusBy([&](struct stat *found) { return ::lstat(path.c_str(), found); });
}

SystemResult<FileStatus> FileHandle::status() const
{
    return statusBy([this](struct stat *found) { return ::fstat(m_number, found); });
}

std::optional<FileIdentity> identityOf(const std::filesystem::path &file)
{
    const auto status = statusOf(file);
    return status ? std::optional(status->identity) : std::nullopt;
}

std::optional<std::filesystem::path> pathOfOpenFile(const FileIdentity &file)
{
    const std::filesystem::path descriptors("/proc/self/fd");
    std::error_code problem;
    for (const std::string &number : files::namesIn(descriptors, problem)) {
        const auto there = statusOf(descriptors / number);
        if (!there || there->identity != file)
            continue;
        std::filesystem::path place = files::linkTarget(descriptors / number, problem);
        return there->names > 0 && !problem ? std::optional(std::move(place)) : std::nullopt;
    }
    return std::nullopt;
}

std::error_code checkAccess(const std::filesystem::path &path, FileAccess access)
{
    const int wanted = access == FileAccess::Read ? R_OK : access == FileAccess::Write ? W_OK : R_OK | W_OK;
    return ::access(path.c_str(), wanted) == 0 ? std::error_code()
                                               : std::error_code(errno, std::generic_category());
}

} // namespace odo
