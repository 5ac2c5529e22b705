// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/backups.h"

#include "core/base/file_system.h"
#include "core/base/platform/user_folders.h"
#include "core/files/file_words.h"
#include "core/files/temporary.h"
#include "core/project/names.h"
#include "core/project/project.h"
#include "core/project/project_rescue.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

namespace odo {

namespace {

const QString dateFormat = QStringLiteral("yyyyMMdd.HHmmss");

QDateTime localTime(Instant instant)
{
    return QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count());
}

Instant instantOf(const QDateTime &time)
{
    return Instant(std::chrono::milliseconds(time.toMSecsSinceEpoch()));
}

/// Of a backup by date; invalid of one that was made before an update.
QDateTime dateInName(const std::filesystem::path &backup)
{
    constexpr std::size_t stampLength = 15;
    const std::string name = backup.filename().string();
    const auto at = name.rfind(".bak-");
    if (at == std::string::npos || name.size() < at + 5 + stampLength)
        return {};
    return QDateTime::fromString(QString::fromStdString(name.substr(at + 5, stampLength)), dateFormat);
}

QDateTime lastWrite(const std::filesystem::path &file)
{
    const QFileInfo info(QString::fromStdString(file.string()));
    return info.exists() ? info.lastModified() : QDateTime();
}

/// A name in the folder of backups that nothing has, nor what SQLite may have beside it.
std::filesystem::path freeBackup(const std::filesystem::path &project, Instant now)
{
    const std::string first = realProjectFile(project).filename().string() + ".bak-" +
                              localTime(now).toString(dateFormat).toStdString();
    std::filesystem::path file = backupFolderOf(project) / first;
    for (int number = 2; files::kindOfItself(file) != files::Kind::Missing; ++number)
        file = backupFolderOf(project) / (first + '.' + std::to_string(number));
    return file;
}

Result<void> makeFolderFor(const std::filesystem::path &file, const Message &what)
{
    std::error_code problem;
    files::makeFolders(file.parent_path(), problem);
    if (problem)
        return fail(ErrorCode::Io, what, cannotBeWritten(problem.message()), chooseWritableFolder());
    return {};
}

Message backupSubject(const std::filesystem::path &project)
{
    return ODO_TEXT("backup.of_project", "backup of '%1'")(Named::file(project.filename()));
}

/// Recordings need the rest of the disk more.
Result<void> checkSpace(const std::filesystem::path &project)
{
    std::error_code problem;
    const files::DiskSpace space = files::diskSpace(realProjectFile(project).parent_path(), problem);
    if (problem)
        return {};
    constexpr std::uintmax_t smallestPart = 20;
    const std::uintmax_t reserve = std::min(backupReserveBytes, space.bytes / smallestPart);
    const std::uintmax_t needed = files::sizeOf(project, problem) + reserve;
    if (space.freeBytes >= needed)
        return {};
    constexpr double bytesInMegabyte = 1e6;
    return fail(ErrorCode::Io, backupSubject(project),
                ODO_TEXT("backup.disk_nearly_full", "the disk has only %1 left")(
                    quantity(double(space.freeBytes) / bytesInMegabyte, 0, "MB")),
                freeDiskSpace());
}

/// Written since then; to the log as well.
bool isWrittenSince(const std::filesystem::path &project, const QDateTime &time)
{
    std::filesystem::path log = realProjectFile(project);
    log += "-wal";
    // The name of a backup has whole seconds: what was written within that second counts as later.
    return std::max(lastWrite(project), lastWrite(log)) >= time;
}

} // namespace

Instant backupTime()
{
    return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
}

std::vector<ProjectBackup> backupsOf(const std::filesystem::path &project)
{
    std::vector<ProjectBackup> backups;
    for (const std::filesystem::path &file : backupFilesOf(project)) {
        const QDateTime date = dateInName(file);
        std::error_code problem;
        backups.push_back({file, instantOf(date.isValid() ? date : lastWrite(file)),
                           files::sizeOf(file, problem), date.isValid()});
    }
    std::ranges::stable_sort(backups, std::greater(), &ProjectBackup::made);
    return backups;
}

Result<ProjectBackup> backUp(const Project &project, Instant now)
{
    ODO_TRY(checkSpace(project.file()));
    const std::filesystem::path file = freeBackup(project.file(), now);
    ODO_TRY(makeFolderFor(file, backupSubject(project.file())));
    ODO_TRY(project.saveCopy(file));
    std::error_code problem;
    return ProjectBackup{file, instantOf(dateInName(file)), files::sizeOf(file, problem), true};
}

Result<std::optional<ProjectBackup>> backUpIfDue(const Project &project, const BackupPlan &plan, Instant now)
{
    if (!plan.isDaily)
        return std::nullopt;
    const std::vector<ProjectBackup> backups = backupsOf(project.file());
    const auto newest = std::ranges::find_if(backups, &ProjectBackup::isByDate);
    std::optional<ProjectBackup> made;
    if (newest == backups.end() || (localTime(newest->made).date() != localTime(now).date() &&
                                    isWrittenSince(project.file(), localTime(newest->made)))) {
        made = ODO_TRY(backUp(project, now));
    }
    removeOldBackups(project.file(), plan.daysKept, now);
    return made;
}

int removeOldBackups(const std::filesystem::path &project, int daysKept, Instant now)
{
    std::vector<ProjectBackup> byDate = backupsOf(project);
    std::erase_if(byDate, [](const ProjectBackup &backup) { return !backup.isByDate; });
    int removed = 0;
    for (std::size_t i = 1; i < byDate.size(); ++i) {
        if (localTime(byDate[i].made).date().daysTo(localTime(now).date()) <= daysKept)
            continue;
        std::error_code problem;
        files::remove(byDate[i].file, problem);
        removed += problem ? 0 : 1;
    }
    return removed;
}

namespace {

/// Names of a that b does not have, as they come.
std::vector<std::string> onlyIn(const std::vector<TrialName> &a, const std::vector<TrialName> &b)
{
    std::set<std::string> others;
    for (const TrialName &trial : b)
        others.insert(trial.name);
    std::vector<std::string> names;
    for (const TrialName &trial : a)
        if (!others.contains(trial.name))
            names.push_back(trial.name);
    return names;
}

/// How many of their oldest changes are the same; both newest first.
std::size_t commonBeginning(const std::vector<ChangeEntry> &a, const std::vector<ChangeEntry> &b)
{
    const auto isSame = [](const ChangeEntry &one, const ChangeEntry &other) {
        return one.made == other.made && one.kind == other.kind && one.words == other.words;
    };
    const auto [end, ignored] = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend(), isSame);
    return static_cast<std::size_t>(std::distance(a.rbegin(), end));
}

std::vector<ChangeEntry> without(std::vector<ChangeEntry> changes, std::size_t oldest)
{
    changes.resize(changes.size() - oldest);
    return changes;
}

/// Under the project's own name, which is the title of one without a title. A backup is whole by itself:
/// it has no log.
Result<std::unique_ptr<Project>> openedCopy(const std::filesystem::path &backup,
                                            const TemporaryFolder &folder, const std::filesystem::path &name)
{
    const std::filesystem::path copy = folder.path() / name.filename();
    QFile file(QString::fromStdString(backup.string()));
    if (!file.copy(QString::fromStdString(copy.string())))
        return fail(ErrorCode::Io, backupSubject(name), cannotBeRead(file.errorString().toStdString()),
                    checkFileMayBeRead());
    QFile::setPermissions(QString::fromStdString(copy.string()), QFile::ReadOwner | QFile::WriteOwner);
    auto project = Project::open(copy, Project::Access::ReadOnly);
    if (!project)
        return fail(project.error().code, backupSubject(name), project.error().why, chooseAnotherOne());
    return project;
}

/// On the backup's own disk, which has space for such a file; elsewhere where that cannot be written to.
Result<std::unique_ptr<TemporaryFolder>> folderForCopy(const std::filesystem::path &backup,
                                                       const Message &what)
{
    auto folder = TemporaryFolder::make(backup.parent_path(), what);
    return folder ? std::move(folder) : TemporaryFolder::make(temporaryFolder(), what);
}

} // namespace

Result<BackupPreview> previewBackup(const std::filesystem::path &backup, Project &present)
{
    const auto folder = ODO_TRY(folderForCopy(backup, backupSubject(present.file())));
    const auto project = ODO_TRY(openedCopy(backup, *folder, present.file()));
    BackupPreview preview;
    preview.title = ODO_TRY(project->title());
    const auto then = ODO_TRY(project->trials().names()), today = ODO_TRY(present.trials().names());
    preview.trialCount =
        std::size_t(std::ranges::count_if(then, [](const TrialName &trial) { return !trial.binned; }));
    preview.trialsLost = onlyIn(today, then);
    preview.trialsBack = onlyIn(then, today);
    const auto changesThen = ODO_TRY(project->changes()), changes = ODO_TRY(present.changes());
    const std::size_t common = commonBeginning(changes, changesThen);
    preview.changesLost = without(changes, common);
    preview.changesBack = without(changesThen, common);
    for (const RecordingRecord &recording : ODO_TRY(project->trials().allRecordings()))
        preview.videosMissing += files::isFile(present.resolve(recording)) ? 0 : 1;
    return preview;
}

Result<std::unique_ptr<ReplacingCopy>> prepareGoingBack(const std::filesystem::path &backup,
                                                        const std::filesystem::path &project)
{
    auto copy = ODO_TRY(ReplacingCopy::make(backup, project));
    ODO_TRY(Project::open(copy->file(), Project::Access::ReadWrite));
    return copy;
}

Result<std::filesystem::path> finishGoingBack(ReplacingCopy &copy, const std::filesystem::path &project,
                                              Instant now)
{
    const std::filesystem::path kept = freeBackup(project, now);
    ODO_TRY(makeFolderFor(kept, backupSubject(project)));
    ODO_TRY(copy.replaceProject(kept));
    return kept;
}

Result<std::filesystem::path> goBackTo(const std::filesystem::path &backup,
                                       const std::filesystem::path &project, Instant now)
{
    const auto copy = ODO_TRY(prepareGoingBack(backup, project));
    auto open = Project::open(project, Project::Access::ReadWrite);
    if (open) {
        (*open)->emptyLog(); // so the file by itself is what the project was
        open->reset();
        return finishGoingBack(*copy, project, now);
    }
    if (open.error().code != ErrorCode::InvalidInput)
        return tl::unexpected(open.error());
    std::filesystem::path kept = realProjectFile(project);
    kept += ".damaged." + localTime(now).toString(dateFormat).toStdString();
    ODO_TRY(copy->replaceProject(kept));
    return kept;
}

} // namespace odo
