// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/descriptor.h"

#include <cerrno>
#include <string_view>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace odo {

bool isAt(const std::filesystem::path &path, int descriptor)
{
    struct stat open
    {
    }, there{};
    return ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &there) == 0 && open.st_ino == there.st_ino &&
           open.st_dev == there.st_dev;
}

int writeAll(int descriptor, std::span<const char> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            return errno;
        if (written > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

std::string randomLetters(std::size_t count)
{
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz234567";
    std::string text(count, '\0');
    if (::getrandom(text.data(), count, 0) != static_cast<ssize_t>(count))
        return {};
    for (char &character : text)
        character = letters[static_cast<unsigned char>(character) % letters.size()];
    return text;
}

} // namespace odo
