// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/file_handle.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace odo {

namespace {

/// Of a call that gives 0 where it succeeds.
std::error_code reasonOf(int failed)
{
    return failed == 0 ? std::error_code() : std::error_code(errno, std::generic_category());
}

std::error_code locked(int descriptor, int how)
{
    int failed = 0;
    do
        failed = ::flock(descriptor, how);
    while (failed != 0 && errno == EINTR);
    return reasonOf(failed);
}

int operationOf(FileHandle::Lock kind)
{
    return kind == FileHandle::Lock::Shared ? LOCK_SH : LOCK_EX;
}

int flagsOf(FileHandle::Links links)
{
    return links == FileHandle::Links::Refused ? O_NOFOLLOW | O_CLOEXEC : O_CLOEXEC;
}

mode_t modeOf(FileHandle::Permissions permissions)
{
    switch (permissions) {
    case FileHandle::Permissions::OwnerAlone:
        return 0600;
    case FileHandle::Permissions::OwnerWrites:
        return 0644;
    case FileHandle::Permissions::UserDefault:
        break;
    }
    return 0666; // less the umask
}

} // namespace

FileHandle::FileHandle(FileHandle &&other) noexcept : m_number(std::exchange(other.m_number, -1)) {}

FileHandle &FileHandle::operator=(FileHandle &&other) noexcept
{
    if (this != &other) {
        close();
        m_number = std::exchange(other.m_number, -1);
    }
    return *this;
}

void FileHandle::close()
{
    if (isOpen())
        ::close(m_number);
    m_number = -1;
}

SystemResult<FileHandle> FileHandle::opened(int number)
{
    if (number < 0)
        return tl::unexpected(reasonOf(number));
    return FileHandle(number);
}

SystemResult<FileHandle> FileHandle::openToRead(const std::filesystem::path &file, Links links)
{
    return opened(::open(file.c_str(), O_RDONLY | O_NONBLOCK | flagsOf(links)));
}

SystemResult<FileHandle> FileHandle::openFolder(const std::filesystem::path &folder, Links links)
{
    return opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | flagsOf(links)));
}

SystemResult<FileHandle> FileHandle::create(const std::filesystem::path &file, Permissions permissions)
{
    return opened(
        ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | flagsOf(Links::Refused), modeOf(permissions)));
}

SystemResult<FileHandle> FileHandle::openOrCreate(const std::filesystem::path &file, Use use,
                                                  Permissions permissions)
{
    const int flags = (use == Use::Write ? O_WRONLY : O_RDWR) | O_CREAT | O_NONBLOCK;
    return opened(::open(file.c_str(), flags | flagsOf(Links::Refused), modeOf(permissions)));
}

bool FileHandle::isAt(const std::filesystem::path &path) const
{
    if (!isOpen())
        return false;
    const auto open = status(), there = statusOfItself(path);
    return open && there && open->identity == there->identity;
}

SystemResult<std::size_t> FileHandle::readStart(std::span<char> into) const
{
    const ssize_t length = ::pread(m_number, into.data(), into.size(), 0);
    if (length < 0)
        return tl::unexpected(reasonOf(-1));
    return static_cast<std::size_t>(length);
}

std::error_code FileHandle::write(std::span<const char> bytes) const
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(m_number, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            return reasonOf(-1);
        if (written > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return {};
}

SystemResult<std::int64_t> FileHandle::seek(std::int64_t offset, int whence) const
{
    const off_t at = ::lseek(m_number, offset, whence);
    if (at < 0)
        return tl::unexpected(reasonOf(-1));
    return at;
}

std::error_code FileHandle::clear() const
{
    return reasonOf(::ftruncate(m_number, 0));
}

std::error_code FileHandle::sync() const
{
    return reasonOf(::fsync(m_number));
}

std::error_code FileHandle::syncData() const
{
    return reasonOf(::fdatasync(m_number));
}

std::error_code FileHandle::setPermissions(unsigned permissions) const
{
    return reasonOf(::fchmod(m_number, permissions));
}

std::error_code FileHandle::lock(Lock kind) const
{
    return locked(m_number, operationOf(kind));
}

std::error_code FileHandle::tryLock(Lock kind) const
{
    return locked(m_number, operationOf(kind) | LOCK_NB);
}

void FileHandle::unlock() const
{
    static_cast<void>(locked(m_number, LOCK_UN));
}

} // namespace odo
