// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/held_file.h"

#include "core/base/file_system.h"
#include "core/files/descriptor.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>

namespace odo {

HeldFile::HeldFile(std::filesystem::path file, Afterwards afterwards, int descriptor)
    : m_file(std::move(file)), m_afterwards(afterwards), m_descriptor(descriptor)
{
}

Result<std::unique_ptr<HeldFile>> HeldFile::take(const std::filesystem::path &file, Afterwards afterwards,
                                                 const std::string &words)
{
    for (;;) {
        // Never through a link: a project may come from anyone, and what the link leads to would be emptied.
        const int descriptor = ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644);
        if (descriptor < 0)
            return fail(ErrorCode::Io, "cannot hold " + file.string(), std::strerror(errno),
                        "check the free space and the rights of its folder");
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            ::close(descriptor);
            return nullptr;
        }
        if (!isAt(file, descriptor)) { // whoever gave it up may have removed it meanwhile
            ::close(descriptor);
            continue;
        }
        std::unique_ptr<HeldFile> held(new HeldFile(file, afterwards, descriptor));
        if (::ftruncate(descriptor, 0) != 0 ||
            ::write(descriptor, words.data(), words.size()) != static_cast<ssize_t>(words.size()))
            return fail(ErrorCode::Io, "cannot hold " + file.string(), std::strerror(errno),
                        "check the free space and the rights of its folder");
        return held;
    }
}

bool HeldFile::isHeld(const std::filesystem::path &file)
{
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        return false;
    const bool held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0;
    ::close(descriptor);
    return held;
}

std::string HeldFile::wordsOf(const std::filesystem::path &file)
{
    constexpr std::streamsize mostWords = 300;
    if (!files::isFile(file))
        return {};
    std::ifstream stream(file);
    std::string words(mostWords, '\0');
    stream.read(words.data(), mostWords);
    words.resize(static_cast<std::size_t>(stream.gcount()));
    return words.substr(0, words.find('\n'));
}

HeldFile::~HeldFile()
{
    if (m_afterwards == Afterwards::Goes)
        ::unlink(m_file.c_str()); // while it is held, so that nobody else's goes
    ::close(m_descriptor);
}

} // namespace odo
