// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;
class ReplacingCopy;

/// How often a project is backed up by itself, and for how long those backups are kept.
struct BackupPlan
{
    static constexpr int fewestDays = 1, mostDays = 3650;

    bool isDaily = true; ///< on the first opening of a day
    int daysKept = 30;
};

/// A copy of a project's file (not of its videos) in its folder of backups, or beside it. Plain value.
struct ProjectBackup
{
    std::filesystem::path file;
    Instant made;
    std::uintmax_t bytes = 0;
    bool isByDate = false; ///< false: made before the project was updated to a newer format; it is kept
};

/// Newest first. Any thread; reads names, sizes and times only.
std::vector<ProjectBackup> backupsOf(const std::filesystem::path &project);

/// Copies the project as it is now to "<name>.backups/<name>.odo.bak-<local date>.<time>", checked by SQLite.
/// On the project's thread. Errors: those of Project::saveCopy; Io where less than backupReserveBytes, or
/// 5 % of a smaller disk, would be left, which recordings need.
Result<ProjectBackup> backUp(const Project &project, Instant now);
inline constexpr std::uintmax_t backupReserveBytes = 1'000'000'000;

/// As backUp, where the plan asks for it: none was made on this (local) day yet, and the project's file was
/// written since the newest. Then removes backups by date that are older than the days that they are kept;
/// the newest one is always kept.
Result<std::optional<ProjectBackup>> backUpIfDue(const Project &project, const BackupPlan &plan, Instant now);

/// How many were removed.
int removeOldBackups(const std::filesystem::path &project, int daysKept, Instant now);

/// What would change if one of a project's backups was restored.
struct BackupPreview
{
    std::string title;
    std::size_t trialCount = 0; ///< in the backup, without those in the bin
    /// By name: trials of today that it does not have; trials of it that are gone today.
    std::vector<std::string> trialsLost, trialsBack;
    /// Changes since the backup, which would be lost; those of the backup that today's project does not have
    /// (one was restored before). Newest first.
    std::vector<ChangeEntry> changesLost, changesBack;
    std::size_t videosMissing = 0; ///< recordings of the backup whose files are no longer there
};

/// Reads a backup in a temporary copy, so it stays as it is, also one of an older format. present: on its
/// thread. Errors: those of Project::open.
Result<BackupPreview> previewBackup(const std::filesystem::path &backup, Project &present);

/// Restores one of the backups of a project. What it was until then becomes a backup itself, whose file is
/// given; that of a damaged project is kept as "<name>.odo.damaged" with the time. The caller sees to it that
/// nobody has the project open. Any thread. Errors: those of ReplacingCopy, and all is as before.
Result<std::filesystem::path> goBackTo(const std::filesystem::path &backup,
                                       const std::filesystem::path &project, Instant now);

/// The same in two steps, for a window that has the project open until the second: the first takes as long
/// as copying the file, and brings a backup of an older format up to date; the second is quick.
Result<std::unique_ptr<ReplacingCopy>> prepareGoingBack(const std::filesystem::path &backup,
                                                        const std::filesystem::path &project);
Result<std::filesystem::path> finishGoingBack(ReplacingCopy &copy, const std::filesystem::path &project,
                                              Instant now);

/// The present time.
Instant backupTime();

} // namespace odo
