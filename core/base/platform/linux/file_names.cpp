// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/file_names.h"

#include "core/base/file_system.h"
#include "core/base/platform/file_handle.h"

#include <cerrno>
#include <cstdio>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

namespace odo {

namespace {

struct CloseFolder
{
    void operator()(DIR *folder) const { ::closedir(folder); }
};

std::error_code lastReason()
{
    return {errno, std::generic_category()};
}

/// The name is made somebody's first, by something that the renaming replaces.
std::error_code takePlace(const std::filesystem::path &from, const std::filesystem::path &to)
{
    std::error_code problem;
    if (files::kindOfItself(from) == files::Kind::Folder)
        problem = makeOwnFolder(to);
    else if (const auto place = FileHandle::create(to, FileHandle::Permissions::OwnerAlone); !place)
        problem = place.error();
    if (problem)
        return problem;
    if (::rename(from.c_str(), to.c_str()) == 0)
        return {};
    problem = lastReason();
    std::remove(to.c_str());
    return problem;
}

} // namespace

std::vector<std::string> files::namesIn(const std::filesystem::path &folder, std::error_code &problem)
{
    std::vector<std::string> names;
    errno = 0; // only errno distinguishes the end of readdir from a failure
    const std::unique_ptr<DIR, CloseFolder> open(::opendir(folder.c_str()));
    while (const dirent *entry = open ? ::readdir(open.get()) : nullptr) {
        const std::string name = entry->d_name;
        if (name != "." && name != "..")
            names.push_back(name);
        errno = 0;
    }
    problem = lastReason();
    return names;
}

std::error_code giveFreeName(const std::filesystem::path &from, const std::filesystem::path &to)
{
    // A hard link fails where a file is, unlike a rename. Not every file system (a USB stick's FAT) knows
    // links.
    if (::link(from.c_str(), to.c_str()) == 0) {
        ::unlink(from.c_str());
        return {};
    }
    if (errno == EEXIST)
        return lastReason();
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0)
        return {};
    if (errno != EINVAL && errno != ENOSYS)
        return lastReason();
    return takePlace(from, to);
}

std::error_code makeOwnFolder(const std::filesystem::path &folder)
{
    return ::mkdir(folder.c_str(), 0700) == 0 ? std::error_code() : lastReason();
}

std::error_code removeFile(const std::filesystem::path &file)
{
    return ::unlink(file.c_str()) == 0 ? std::error_code() : lastReason();
}

std::error_code syncToDisk(const std::filesystem::path &path)
{
    const auto handle = FileHandle::openToRead(path, FileHandle::Links::Followed);
    return handle ? handle->sync() : handle.error();
}

bool isDiskFull(const std::error_code &problem)
{
    return problem.value() == ENOSPC || problem.value() == EDQUOT;
}

} // namespace odo
