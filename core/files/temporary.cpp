// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/temporary.h"

#include "core/base/file_system.h"
#include "core/files/descriptor.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <new>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace odo {

namespace {

constexpr std::string_view nameStart = ".odograph-", nameEnd = ".part", nameLetters = "abcdefghijklmnopqrstuvwxyz234567";
constexpr std::size_t lettersOfName = 12;
constexpr std::time_t longestWritingS = 24 * 3600; // where the file system knows no locks

/// Empty, with errno, where the system has no random numbers.
std::string randomName()
{
    const std::string letters = randomLetters(lettersOfName);
    return letters.empty() ? letters : std::string(nameStart) + letters + std::string(nameEnd);
}

void removeAll(const std::filesystem::path &path)
{
    try {
        files::removeAll(path);
    } catch (const std::bad_alloc &) { // it stays, and is swept later
    }
}

void removeIfStray(const std::filesystem::path &path)
{
    struct stat status
    {
    };
    if (::lstat(path.c_str(), &status) != 0 || status.st_uid != ::geteuid())
        return;
    if (S_ISREG(status.st_mode) && status.st_nlink > 1) { // it has got its own name already, and this one was left
        ::unlink(path.c_str());
        return;
    }
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0)
        return;
    const bool isUnlocked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const bool isUnknown = !isUnlocked && errno != EWOULDBLOCK;
    if (isUnlocked || (isUnknown && std::time(nullptr) - status.st_mtime > longestWritingS)) {
        if (S_ISDIR(status.st_mode))
            removeAll(path);
        else
            ::unlink(path.c_str());
    }
    ::close(descriptor);
}

void sweep(const std::filesystem::path &folder)
{
    std::error_code ignored;
    for (const std::string &name : files::namesIn(folder, ignored))
        if (isTemporaryName(name))
            removeIfStray(folder / name);
}

tl::unexpected<Error> cannotMake(const std::filesystem::path &folder, const std::string &what, int reason)
{
    if (!files::isFolder(folder))
        return fail(ErrorCode::NotFound, what, "there is no folder '" + folder.string() + "'",
                    "make the folder first, or choose another one");
    if (reason == ENOSPC || reason == EDQUOT)
        return fail(ErrorCode::Io, what, "the disk is full", "make room on the disk and try again");
    return fail(ErrorCode::ReadOnly, what, "the folder '" + folder.string() + "' cannot be written to (" + std::strerror(reason) + ")",
                "choose a folder that you may write to");
}

/// What was made by `make` (path, giving a descriptor or -1) under a new name, locked.
template <class Make>
Result<std::pair<std::filesystem::path, int>> madeIn(const std::filesystem::path &folder, const std::string &what, const Make &make)
{
    sweep(folder);
    constexpr int mostAttempts = 100;
    for (int attempt = 0; attempt < mostAttempts; ++attempt) {
        const std::string name = randomName();
        if (name.empty())
            break;
        const std::filesystem::path path = folder / name;
        const int descriptor = make(path);
        if (descriptor < 0 && errno != EEXIST)
            break;
        if (descriptor < 0)
            continue;
        static_cast<void>(::flock(descriptor, LOCK_EX)); // where there are no locks, its age tells
        if (isAt(path, descriptor))
            return std::pair(path, descriptor);
        ::close(descriptor); // somebody has swept it, just before it was locked
    }
    return cannotMake(folder, what, errno);
}

} // namespace

bool isTemporaryName(const std::filesystem::path &name)
{
    const std::string text = name.string();
    if (text.size() != nameStart.size() + lettersOfName + nameEnd.size() || !text.starts_with(nameStart) || !text.ends_with(nameEnd))
        return false;
    return std::string_view(text).substr(nameStart.size(), lettersOfName).find_first_not_of(nameLetters) == std::string_view::npos;
}

bool syncToDisk(const std::filesystem::path &path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    const bool written = ::fsync(descriptor) == 0;
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    return written;
}

namespace {

/// The name is made somebody's first, by something that the renaming replaces. 0, or errno.
int takePlace(const std::filesystem::path &from, const std::filesystem::path &to)
{
    const bool isFolder = files::kindOfItself(from) == files::Kind::Folder;
    const int place = isFolder ? ::mkdir(to.c_str(), 0700) : ::open(to.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (place < 0)
        return errno;
    if (!isFolder)
        ::close(place);
    if (::rename(from.c_str(), to.c_str()) == 0)
        return 0;
    const int failed = errno;
    std::remove(to.c_str());
    return failed;
}

} // namespace

int giveFreeName(const std::filesystem::path &from, const std::filesystem::path &to)
{
    // A hard link fails where a file is, unlike a rename. Not every file system (a USB stick's FAT) knows links.
    if (::link(from.c_str(), to.c_str()) == 0) {
        ::unlink(from.c_str());
        return 0;
    }
    if (errno == EEXIST)
        return errno;
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0)
        return 0;
    if (errno != EINVAL && errno != ENOSYS)
        return errno;
    return takePlace(from, to);
}

TemporaryFile::TemporaryFile(std::filesystem::path path, int descriptor, std::string what)
    : m_path(std::move(path)), m_descriptor(descriptor), m_what(std::move(what))
{
}

Result<std::unique_ptr<TemporaryFile>> TemporaryFile::make(const std::filesystem::path &folder, const std::string &what)
{
    auto made = madeIn(folder, what, [](const std::filesystem::path &path) {
        return ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    });
    if (!made)
        return tl::unexpected(made.error());
    return std::unique_ptr<TemporaryFile>(new TemporaryFile(std::move(made->first), made->second, what));
}

TemporaryFile::~TemporaryFile()
{
    if (isAt(m_path, m_descriptor)) // it has no other name yet
        ::unlink(m_path.c_str());
    ::close(m_descriptor);
}

tl::unexpected<Error> TemporaryFile::failure(int reason) const
{
    if (reason == EEXIST)
        return fail(ErrorCode::AlreadyExists, m_what, "it is there already", "choose another name or folder");
    return fail(ErrorCode::Io, m_what, std::string("it cannot be written (") + std::strerror(reason) + ")",
                "choose a folder that you may write to and that has room");
}

Result<void> TemporaryFile::sync() const
{
    return ::fsync(m_descriptor) == 0 ? Result<void>() : failure(errno);
}

Result<void> TemporaryFile::replace(const std::filesystem::path &target)
{
    if (auto synced = sync(); !synced)
        return synced;
    if (::rename(m_path.c_str(), target.c_str()) != 0)
        return failure(errno);
    syncToDisk(m_path.parent_path()); // some file systems cannot sync a folder: the file itself is safe already
    return {};
}

Result<void> TemporaryFile::publish(const std::filesystem::path &target)
{
    if (auto synced = sync(); !synced)
        return synced;
    if (const int reason = giveFreeName(m_path, target); reason != 0)
        return failure(reason);
    syncToDisk(m_path.parent_path());
    return {};
}

Result<std::unique_ptr<TemporaryFolder>> TemporaryFolder::make(const std::filesystem::path &folder, const std::string &what)
{
    auto made = madeIn(folder, what, [](const std::filesystem::path &path) {
        if (::mkdir(path.c_str(), 0700) != 0)
            return -1;
        const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (descriptor < 0 && errno == ENOENT)
            errno = EEXIST; // somebody has swept it: the next name
        return descriptor;
    });
    if (!made)
        return tl::unexpected(made.error());
    std::unique_ptr<TemporaryFolder> temporary(new TemporaryFolder(std::move(made->first), made->second));
    if (::mkdir(temporary->path().c_str(), 0700) != 0)
        return cannotMake(folder, what, errno);
    return temporary;
}

TemporaryFolder::~TemporaryFolder()
{
    if (isAt(m_outer, m_descriptor))
        removeAll(m_outer);
    ::close(m_descriptor);
}

} // namespace odo
