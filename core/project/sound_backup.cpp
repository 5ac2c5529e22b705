// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/sound_backup.h"

#include "core/base/file_system.h"
#include "core/project/connection.h"
#include "core/project/file_header.h"
#include "core/project/quick_check.h"
#include "core/project/schema.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace odo {

namespace {

/// "3" and "3.2" of "lesson.odo.bak-3.2": not what is being made beside them.
bool isBackupNumber(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789.") == std::string_view::npos;
}

bool isSound(const std::filesystem::path &backup)
{
    if (!checkFileHeader(backup, projectMigrator().newestVersion()))
        return false;
    const auto connection = ProjectConnection::open(backup, DatabaseAccess::Immutable);
    if (!connection)
        return false;
    return passesQuickCheck(**connection).value_or(false);
}

} // namespace

std::optional<std::filesystem::path> soundBackupOf(const std::filesystem::path &project)
{
    const std::string start = project.filename().string() + ".bak-";
    const std::filesystem::path folder = project.has_parent_path() ? project.parent_path() : std::filesystem::path(".");
    std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> backups;
    std::error_code problem;
    for (const std::string &name : files::namesIn(folder, problem)) {
        if (!name.starts_with(start) || !isBackupNumber(std::string_view(name).substr(start.size())))
            continue;
        const auto written = files::lastWritten(folder / name, problem);
        if (!problem)
            backups.emplace_back(written, folder / name);
    }
    std::ranges::sort(backups, std::greater());
    const auto sound = std::ranges::find_if(backups, [](const auto &backup) { return isSound(backup.second); });
    return sound == backups.end() ? std::nullopt : std::optional(sound->second);
}

Result<void> worthOpening(const std::filesystem::path &project)
{
    auto header = checkFileHeader(project, projectMigrator().newestVersion());
    if (!header && header.error().code == ErrorCode::InvalidInput && soundBackupOf(project))
        return {};
    return header;
}

std::string adviceToCopy(const std::filesystem::path &backup)
{
    return "copy '" + backup.filename().string() + "', which is sound, to a new name and open that, and keep the damaged file";
}

Error namingABackup(Error error, const std::filesystem::path &project)
{
    if (error.code != ErrorCode::InvalidInput)
        return error;
    if (const auto backup = soundBackupOf(project))
        error.advice = adviceToCopy(*backup);
    return error;
}

} // namespace odo
