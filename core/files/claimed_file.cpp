// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/claimed_file.h"

#include "core/files/temporary.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
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

std::filesystem::path numbered(const std::filesystem::path &folder, const std::string &stem,
                               const std::string &ending, int number)
{
    return folder / (number == 1 ? stem + ending : stem + "_" + std::to_string(number) + ending);
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

} // namespace

ClaimedFile::ClaimedFile(std::filesystem::path path, int descriptor, Made made)
    : m_path(std::move(path)), m_descriptor(descriptor), m_isOurs(made == Made::Here), m_goes(m_isOurs)
{
}

ClaimedFile::ClaimedFile(ClaimedFile &&other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_isOurs(other.m_isOurs), m_goes(other.m_goes)
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
    if (m_goes && isAt(m_path, m_descriptor))
        ::unlink(m_path.c_str()); // while it is claimed
    ::close(m_descriptor);
    m_descriptor = -1;
}

void ClaimedFile::remove()
{
    m_goes = m_isOurs;
    close();
}

ClaimedFile::Outcome<ClaimedFile> ClaimedFile::create(const std::filesystem::path &folder,
                                                      const std::string &stem, const std::string &ending)
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
        lock(descriptor, LOCK_EX);  // waits for who looks whether it is held
        if (isAt(path, descriptor)) // who removes stray files may have been faster
            return file;
    }
}

ClaimedFile::Outcome<ClaimedFile> ClaimedFile::begin(const std::filesystem::path &folder)
{
    for (;;) {
        const std::string name = randomLetters(6);
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
        if (isAt(path, descriptor))
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

ClaimedFile::Outcome<std::int64_t> ClaimedFile::bytes() const
{
    struct stat status
    {
    };
    if (::fstat(m_descriptor, &status) != 0)
        return tl::unexpected(systemError(errno));
    return status.st_size;
}

std::error_code ClaimedFile::write(std::span<const char> bytes) const
{
    const int failed = writeAll(m_descriptor, bytes);
    return failed == 0 ? std::error_code() : systemError(failed);
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
        const int failed = giveFreeName(m_path, path);
        if (failed == EEXIST)
            continue;
        if (failed != 0)
            return systemError(failed);
        m_path = std::move(path);
        return {};
    }
}

} // namespace odo
