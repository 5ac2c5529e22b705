// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/claimed_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <string_view>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace odo {

namespace {

constexpr mode_t asTheUserWishes = 0666; // less the umask
constexpr int newFile = O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC | O_NOFOLLOW;

std::error_code systemError(int number)
{
    return {number, std::generic_category()};
}

std::filesystem::path numbered(const std::filesystem::path &folder, const std::string &stem, const std::string &ending, int number)
{
    return folder / (number == 1 ? stem + ending : stem + "_" + std::to_string(number) + ending);
}

/// Six that nobody can foresee; empty: errno says why.
std::string randomLetters()
{
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz012345";
    std::array<unsigned char, 6> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        return {};
    std::string text;
    for (const unsigned char byte : bytes)
        text += letters[byte % letters.size()];
    return text;
}

/// 0, or why not. Some file systems of a network know no locks: there a name is still nobody else's.
int lock(int descriptor, int how)
{
    int failed = 0;
    do
        failed = ::flock(descriptor, how) == 0 ? 0 : errno;
    while (failed == EINTR);
    return failed == EWOULDBLOCK ? failed : 0;
}

/// Gives a file a further name, or its only one, that must be nobody's. 0, or why not.
int giveName(const std::filesystem::path &from, const std::filesystem::path &to)
{
    if (::link(from.c_str(), to.c_str()) == 0) {
        ::unlink(from.c_str());
        return 0;
    }
    if (errno == EEXIST)
        return errno;
    // A USB stick's file system knows no links.
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0)
        return 0;
    if (errno != EINVAL && errno != ENOSYS)
        return errno;
    const int place = ::open(to.c_str(), newFile, asTheUserWishes);
    if (place < 0)
        return errno;
    ::close(place);
    if (::rename(from.c_str(), to.c_str()) == 0)
        return 0;
    const int failed = errno;
    ::unlink(to.c_str());
    return failed;
}

} // namespace

ClaimedFile::ClaimedFile(std::filesystem::path path, int descriptor, Made made)
    : m_path(std::move(path)), m_descriptor(descriptor), m_isOurs(made == Made::Here), m_goes(m_isOurs)
{
}

ClaimedFile::ClaimedFile(ClaimedFile &&other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)), m_isOurs(other.m_isOurs), m_goes(other.m_goes)
{
}

ClaimedFile &ClaimedFile::operator=(ClaimedFile &&other) noexcept
{
    if (this != &other) {
        close();
        m_path = std::move(other.m_path);
        m_descriptor = std::exchange(other.m_descriptor, -1);
        m_isOurs = other.m_isOurs;
        m_goes = other.m_goes;
    }
    return *this;
}

ClaimedFile::~ClaimedFile()
{
    close();
}

void ClaimedFile::close()
{
    if (m_descriptor < 0)
        return;
    if (m_goes && isAt(m_path))
        ::unlink(m_path.c_str()); // while it is claimed
    ::close(m_descriptor);
    m_descriptor = -1;
}

void ClaimedFile::remove()
{
    m_goes = m_isOurs;
    close();
}

/// Whether the path leads to this very file: somebody may have renamed or removed it, and another one may have its name.
bool ClaimedFile::isAt(const std::filesystem::path &path) const
{
    struct stat mine
    {
    }, there{};
    return ::fstat(m_descriptor, &mine) == 0 && ::lstat(path.c_str(), &there) == 0 && mine.st_ino == there.st_ino &&
           mine.st_dev == there.st_dev;
}

ClaimedFile::Outcome<ClaimedFile> ClaimedFile::create(const std::filesystem::path &folder, const std::string &stem, const std::string &ending)
{
    for (int number = 1;;) {
        const std::filesystem::path path = numbered(folder, stem, ending, number);
        const int descriptor = ::open(path.c_str(), newFile, asTheUserWishes);
        if (descriptor < 0 && errno == EEXIST) {
            ++number;
            continue;
        }
        if (descriptor < 0)
            return tl::unexpected(systemError(errno));
        ClaimedFile file(path, descriptor, Made::Here);
        lock(descriptor, LOCK_EX); // waits for who looks whether it is held
        if (file.isAt(path))       // who removes stray files may have been faster
            return file;
    }
}

ClaimedFile::Outcome<ClaimedFile> ClaimedFile::begin(const std::filesystem::path &folder)
{
    for (;;) {
        const std::string name = randomLetters();
        if (name.empty())
            return tl::unexpected(systemError(errno));
        const std::filesystem::path path = folder / (".new-" + name + ".part");
        const int descriptor = ::open(path.c_str(), newFile, asTheUserWishes);
        if (descriptor < 0 && errno == EEXIST)
            continue;
        if (descriptor < 0)
            return tl::unexpected(systemError(errno));
        ClaimedFile file(path, descriptor, Made::Here);
        lock(descriptor, LOCK_EX);
        if (file.isAt(path))
            return file;
    }
}

ClaimedFile::Outcome<ClaimedFile> ClaimedFile::hold(const std::filesystem::path &path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        return tl::unexpected(systemError(errno));
    ClaimedFile file(path, descriptor, Made::Before);
    if (const int held = lock(descriptor, LOCK_SH | LOCK_NB); held != 0)
        return tl::unexpected(systemError(held));
    return file;
}

std::error_code ClaimedFile::write(std::span<const char> bytes) const
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            return systemError(errno);
        if (written > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return {};
}

std::error_code ClaimedFile::sync() const
{
    return ::fsync(m_descriptor) == 0 ? std::error_code() : systemError(errno);
}

std::error_code ClaimedFile::publish(const std::string &stem, const std::string &ending)
{
    const std::filesystem::path folder = m_path.parent_path();
    for (int number = 1;; ++number) {
        std::filesystem::path path = numbered(folder, stem, ending, number);
        const int failed = giveName(m_path, path);
        if (failed == EEXIST)
            continue;
        if (failed != 0)
            return systemError(failed);
        m_path = std::move(path);
        return {};
    }
}

} // namespace odo
