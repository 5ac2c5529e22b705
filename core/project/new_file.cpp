// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/new_file.h"

#include "core/base/file_system.h"
#include "core/base/platform/file_handle.h"
#include "core/files/file_words.h"
#include "core/files/temporary.h"
#include "core/project/internal/words.h"

#include <system_error>

namespace odo {

namespace {

std::filesystem::path locationFolder(const std::filesystem::path &file)
{
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

} // namespace

NewFile::NewFile(std::filesystem::path target, Message what)
    : m_target(std::move(target)), m_what(std::move(what))
{
}

NewFile::~NewFile() = default;

tl::unexpected<Error> NewFile::alreadyThere() const
{
    return fail(ErrorCode::AlreadyExists, m_what,
                ODO_TEXT("project.file_there_already", "a file of that name already exists"),
                ODO_TEXT("project.remove_file_first", "choose another name, or remove that file first"));
}

tl::unexpected<Error> NewFile::ioError(const std::error_code &reason) const
{
    return fail(ErrorCode::Io, m_what, writingFailed(reason), checkDiskAndRetry());
}

Result<void> NewFile::prepare()
{
    std::error_code problem;
    static_cast<void>(files::kindOf(m_target, problem));
    const std::filesystem::path folder = locationFolder(m_target);
    if (m_target.filename().empty())
        return fail(ErrorCode::InvalidInput, m_what, ODO_TEXT("project.no_file_name", "it has no file name"),
                    ODO_TEXT("project.give_file_a_name", "give the file a name"));
    if (files::kindOfItself(m_target) != files::Kind::Missing)
        return alreadyThere();
    if (problem == std::errc::filename_too_long)
        return nameIsTooLong(m_what);
    m_folder = ODO_TRY(TemporaryFolder::make(folder, m_what));
    m_temporary = m_folder->path() / "new.odo"; // short: SQLite takes no paths beyond 512 bytes
    const auto file = FileHandle::create(m_temporary, FileHandle::Permissions::UserDefault);
    return file ? Result<void>() : ioError(file.error());
}

Result<void> NewFile::publish()
{
    if (const std::error_code problem = syncToDisk(m_temporary))
        return ioError(problem);
    if (const std::error_code problem = giveFreeName(m_temporary, m_target))
        return problem == std::errc::file_exists ? alreadyThere() : ioError(problem);
    // some file systems cannot sync a folder: the file itself is safe already
    syncToDisk(locationFolder(m_target));
    return {};
}

} // namespace odo
