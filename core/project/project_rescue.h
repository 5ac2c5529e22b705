// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/message.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class TemporaryFolder;

/// "<name>.backups" beside a project, links followed: the folder of its backups by date
/// (core/workflow/backups.h).
std::filesystem::path backupFolderOf(const std::filesystem::path &project);

/// The backups of a project, newest first by when their files were written: those that migrations have left
/// beside it ("<name>.odo.bak-<version>"), and those by date in its folder of backups
/// ("<name>.odo.bak-20261130.174512"). Any thread; quick.
std::vector<std::filesystem::path> backupFilesOf(const std::filesystem::path &project);

/// The newest of them in which SQLite finds nothing wrong. Any thread; reads them wholly, up to the first
/// that is sound.
std::optional<std::filesystem::path> soundBackupOf(const std::filesystem::path &project);

/// Whether a window has anything to show of a file: the header of a project, or a sound backup of it that can
/// be restored. The errors are those of Project::checkHeader.
Result<void> worthOpening(const std::filesystem::path &project);

/// To copy that backup by hand, as the advice of an error.
Message adviceToCopy(const std::filesystem::path &backup);

/// Why a project cannot be used, with the advice to take the sound backup where there is one. Only where its
/// content is at fault (InvalidInput). The project is left as it is.
Error namingABackup(Error error, const std::filesystem::path &project);

/// Which files a restored project was made of.
struct RestoredBackup
{
    std::filesystem::path backup;  ///< is still there
    std::filesystem::path damaged; ///< where the damaged file was kept, with what SQLite had beside it
};

/// Puts a copy of the newest sound backup in the place of a damaged project, which is kept as
/// "<name>.odo.damaged" (or another name with a number). Nothing is removed or written over, and killed at
/// any moment the project's name has the one or the other behind it (on a disk without links, the damaged
/// file may only be left under its new name). The caller sees to it that nobody has the project open. Any
/// thread; reads and writes the whole file. Errors: NotFound without a sound backup; those of writing, and
/// all is as before.
Result<RestoredBackup> restoreBackup(const std::filesystem::path &project);

/// A copy of a backup in a temporary folder beside a project, whose place it is to take. Removed unless it
/// did. Any thread, one at a time.
class ReplacingCopy
{
public:
    /// Reads and writes the whole file. Errors: those of writing; InvalidInput for a backup that is damaged.
    static Result<std::unique_ptr<ReplacingCopy>> make(const std::filesystem::path &backup,
                                                       const std::filesystem::path &project);
    ~ReplacingCopy();
    ReplacingCopy(const ReplacingCopy &) = delete;
    ReplacingCopy &operator=(const ReplacingCopy &) = delete;

    std::filesystem::path file() const;
    /// Once. The project, with what SQLite has beside it, gets the other name, in the same file system:
    /// killed at any moment, its own name has the one or the other behind it. Nobody has it open. Quick.
    Result<void> replaceProject(const std::filesystem::path &kept);

private:
    ReplacingCopy(std::filesystem::path project, Message advice, std::unique_ptr<TemporaryFolder> folder);
    const std::filesystem::path m_project;
    const Message m_advice;
    const std::unique_ptr<TemporaryFolder> m_folder;
};

class Project;

/// Copies an open project whose file is no longer in its place (Project::isInPlace) to "<name> (rescued).odo"
/// beside where it was, or where its file was moved to when that folder is gone, or in the home folder;
/// numbered where a file of that name is. Gives the new file. On the project's thread.
Result<std::filesystem::path> rescueProject(const Project &project);

/// The kind of file system that a path is on, as the system's list of mounts ("/proc/self/mounts") names it:
/// "ext4", "nfs4", "fuse.sshfs". Empty where the list does not say.
std::string fileSystemOf(const std::filesystem::path &file, const std::string &mounts);

/// A warning where a project is on a network disk, or in a folder that a program such as
/// Dropbox keeps the same on several computers: it is copied while it changes, by parts. Recognised by the
/// kind of file system, the folders' names and the marks that such programs leave. Any thread; quick.
std::optional<Message> locationWarning(const std::filesystem::path &project);
std::optional<Message> locationWarning(const std::filesystem::path &project, const std::string &mounts);

} // namespace odo
