// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/claimed_folder.h"

#include "core/base/file_system.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <new>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace odo {

namespace {

constexpr std::size_t randomCharacters = 6; // of mkdtemp

std::error_code folderError(int number)
{
    return {number, std::generic_category()};
}

/// Its descriptor, locked; -1 where somebody has it, or it is no folder any more. A file system of a network may know no locks: then
/// what a killed program left stays, and what is made is nobody else's all the same.
int takeFolder(const std::filesystem::path &folder, bool isNew)
{
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0)
        return -1;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || (isNew && errno != EWOULDBLOCK))
        return descriptor;
    ::close(descriptor);
    return -1;
}

void removeWithContent(const std::filesystem::path &folder) noexcept
{
    try {
        files::removeAll(folder);
    } catch (const std::bad_alloc &) { // it stays, under a name that says what it is
    }
}

void sweep(const std::filesystem::path &parent, const std::string &start)
{
    std::error_code ignored;
    for (const std::string &name : files::namesIn(parent, ignored)) {
        if (!name.starts_with(start) || name.size() != start.size() + randomCharacters)
            continue;
        const int descriptor = takeFolder(parent / name, false);
        if (descriptor < 0)
            continue;
        removeWithContent(parent / name);
        ::close(descriptor);
    }
}

} // namespace

tl::expected<ClaimedFolder, std::error_code> ClaimedFolder::make(const std::filesystem::path &parent, const std::string &prefix)
{
    sweep(parent, prefix + '-');
    for (;;) {
        std::string name = (parent / (prefix + '-')).string() + std::string(randomCharacters, 'X');
        if (!::mkdtemp(name.data()))
            return tl::unexpected(folderError(errno));
        const int descriptor = takeFolder(name, true);
        if (descriptor < 0)
            continue; // who sweeps was faster
        struct stat made
        {
        };
        if (::stat(name.c_str(), &made) == 0) {
            ::chmod(name.c_str(), 0755); // as any folder
            return ClaimedFolder(name, descriptor);
        }
        ::close(descriptor);
    }
}

ClaimedFolder::ClaimedFolder(ClaimedFolder &&other) noexcept
    : m_path(std::exchange(other.m_path, {})), m_descriptor(std::exchange(other.m_descriptor, -1))
{
}

ClaimedFolder::~ClaimedFolder()
{
    if (m_descriptor < 0)
        return;
    if (!m_path.empty())
        removeWithContent(m_path);
    ::close(m_descriptor);
}

std::error_code ClaimedFolder::publish(const std::filesystem::path &name)
{
    if (::renameat2(AT_FDCWD, m_path.c_str(), AT_FDCWD, name.c_str(), RENAME_NOREPLACE) != 0) {
        if (errno != EINVAL && errno != ENOSYS)
            return folderError(errno);
        // rename() replaces nothing but an empty folder.
        if (::rename(m_path.c_str(), name.c_str()) != 0)
            return folderError(errno);
    }
    m_path.clear();
    return {};
}

} // namespace odo
