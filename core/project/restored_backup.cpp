// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/restored_backup.h"

#include "core/base/file_system.h"
#include "core/files/temporary.h"
#include "core/project/connection.h"
#include "core/project/migrator.h"
#include "core/project/side_files.h"
#include "core/project/sound_backup.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <unistd.h>
#include <vector>

namespace odo {

namespace {

bool isThere(const std::filesystem::path &file)
{
    return files::kindOfItself(file) != files::Kind::Missing;
}

std::filesystem::path freeName(const std::filesystem::path &first)
{
    const auto isFree = [](const std::filesystem::path &name) {
        return !isThere(name) && std::ranges::none_of(sideFileSuffixes, [&name](const char *side) { return isThere(besideFile(name, side)); });
    };
    std::filesystem::path name = first;
    for (int i = 2; !isFree(name); ++i)
        name = besideFile(first, '.' + std::to_string(i));
    return name;
}

/// Gives a project and what lies beside it a second name, and takes that back unless it is told to keep it.
class KeptAside
{
public:
    KeptAside(std::filesystem::path project, std::filesystem::path kept) : m_project(std::move(project)), m_kept(std::move(kept)) {}
    KeptAside(const KeptAside &) = delete;
    KeptAside &operator=(const KeptAside &) = delete;
    ~KeptAside()
    {
        for (const auto &[from, to] : m_moved)
            static_cast<void>(std::rename(to.c_str(), from.c_str()));
        if (m_isLinked)
            ::unlink(m_kept.c_str());
    }

    const std::filesystem::path &kept() const { return m_kept; }
    /// False, with errno set, where the system refuses.
    bool take()
    {
        // A link leaves the file under its name until another replaces it. Not every disk (a USB stick's FAT) knows links.
        m_isLinked = ::link(m_project.c_str(), m_kept.c_str()) == 0;
        for (const char *side : sideFileSuffixes) {
            if (isThere(besideFile(m_project, side)) && !move(besideFile(m_project, side), besideFile(m_kept, side)))
                return false;
        }
        return m_isLinked || move(m_project, m_kept);
    }
    void keep()
    {
        m_moved.clear();
        m_isLinked = false;
    }

private:
    bool move(const std::filesystem::path &from, const std::filesystem::path &to)
    {
        if (std::rename(from.c_str(), to.c_str()) != 0)
            return false;
        m_moved.emplace_back(from, to);
        return true;
    }

    const std::filesystem::path m_project, m_kept;
    std::vector<std::pair<std::filesystem::path, std::filesystem::path>> m_moved;
    bool m_isLinked = false;
};

} // namespace

Result<RestoredBackup> restoreBackup(const std::filesystem::path &project)
{
    const std::string what = "project '" + project.filename().string() + "'";
    const auto backup = soundBackupOf(project);
    if (!backup)
        return fail(ErrorCode::NotFound, what, "no sound backup lies beside it", "restore it from a backup copy");
    const auto refused = [&](ErrorCode code, const std::string &why) { return fail(code, what, why, adviceToCopy(*backup)); };
    std::error_code problem;
    std::filesystem::path real = files::realPath(project, problem); // a link stays one
    if (problem)
        real = project;
    const auto folder = TemporaryFolder::make(real.parent_path(), what);
    if (!folder)
        return refused(folder.error().code, folder.error().why);
    const std::filesystem::path fresh = (*folder)->path() / real.filename();
    const auto source = ProjectConnection::open(*backup, DatabaseAccess::Immutable);
    if (!source)
        return refused(source.error().code, source.error().why);
    if (auto copied = copyDatabase(**source, fresh); !copied)
        return refused(copied.error().code, copied.error().why);
    KeptAside aside(real, freeName(besideFile(real, ".damaged")));
    const auto failed = [&refused] { return refused(ErrorCode::Io, std::string("writing it failed (") + std::strerror(errno) + ")"); };
    if (!aside.take())
        return failed();
    syncToDisk(real.parent_path()); // some file systems cannot sync a folder: both files are safe already
    if (std::rename(fresh.c_str(), real.c_str()) != 0)
        return failed();
    aside.keep();
    syncToDisk(real.parent_path());
    return RestoredBackup{*backup, aside.kept()};
}

} // namespace odo
