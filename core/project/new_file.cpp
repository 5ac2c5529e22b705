// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/new_file.h"

#include "core/base/file_system.h"
#include "core/project/side_files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace odo {

namespace {

std::filesystem::path placeFolder(const std::filesystem::path &file)
{
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

} // namespace

bool syncToDisk(const std::filesystem::path &path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    const bool written = ::fsync(descriptor) == 0;
    ::close(descriptor);
    return written;
}

NewFile::NewFile(std::filesystem::path target, std::string what)
    : m_target(std::move(target)), m_temporary(m_target), m_what(std::move(what))
{
    m_temporary += ".new-" + std::to_string(::getpid());
    m_toRemove.push_back(m_temporary.string());
    for (const char *side : sideFileSuffixes)
        m_toRemove.push_back(m_temporary.string() + side);
}

NewFile::~NewFile()
{
    if (!m_prepared)
        return;
    for (const std::string &file : m_toRemove) // without any memory
        ::unlink(file.c_str());
}

tl::unexpected<Error> NewFile::alreadyThere() const
{
    return fail(ErrorCode::AlreadyExists, m_what, "a file of that name is there already",
                "choose another name, or remove that file first");
}

Result<void> NewFile::prepare()
{
    const std::filesystem::path folder = placeFolder(m_target);
    if (!files::isFolder(folder))
        return fail(ErrorCode::NotFound, m_what, "there is no folder '" + folder.string() + "'",
                    "make the folder first, or choose another one");
    if (m_target.filename().empty())
        return fail(ErrorCode::InvalidInput, m_what, "it has no file name", "give the file a name");
    if (files::kindOfItself(m_target) != files::Kind::Missing)
        return alreadyThere();
    const int descriptor = ::open(m_temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        const int reason = errno;
        if (reason == ENOSPC || reason == EDQUOT)
            return fail(ErrorCode::Io, m_what, "the disk is full", "make room on the disk and try again");
        if (reason == ENAMETOOLONG)
            return fail(ErrorCode::InvalidInput, m_what, "its name is too long", "choose a shorter name");
        return fail(ErrorCode::ReadOnly, m_what,
                    "the folder '" + folder.string() + "' cannot be written to (" + std::strerror(reason) +
                        ")",
                    "choose a folder that you may write to");
    }
    ::close(descriptor);
    m_prepared = true;
    return {};
}

Result<void> NewFile::publish()
{
    const auto ioError = [this](int reason) {
        return fail(ErrorCode::Io, m_what, std::string("writing it failed (") + std::strerror(reason) + ")",
                    "check the disk and try again");
    };
    if (!syncToDisk(m_temporary))
        return ioError(errno);
    // A hard link fails where a file is, unlike a rename. Not every file system (a USB stick's FAT) knows
    // links.
    if (::link(m_temporary.c_str(), m_target.c_str()) != 0) {
        if (errno == EEXIST)
            return alreadyThere();
        if (files::kindOfItself(m_target) != files::Kind::Missing)
            return alreadyThere();
        if (::rename(m_temporary.c_str(), m_target.c_str()) != 0)
            return ioError(errno);
    }
    syncToDisk(placeFolder(m_target)); // some file systems cannot sync a folder: the file itself is safe already
    return {};
}

} // namespace odo
