// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/project/names.h"
#include "core/project/project_locks.h"
#include "core/project/project_rescue.h"
#include "core/workflow/backups.h"

#include <QJsonArray>

namespace odo {

namespace {

QString pathText(const std::filesystem::path &path)
{
    return QString::fromStdString(path.string());
}

QJsonObject backupJson(const ProjectBackup &backup)
{
    return {{QStringLiteral("file"), pathText(backup.file)},
            {QStringLiteral("made"), dateText(backup.made)},
            {QStringLiteral("bytes"), qint64(backup.bytes)},
            {QStringLiteral("before_update"), !backup.isByDate}};
}

QString backupLine(const ProjectBackup &backup)
{
    constexpr double bytesInMegabyte = 1e6;
    return QStringLiteral("%1  %2 MB  %3%4")
        .arg(dateText(backup.made))
        .arg(double(backup.bytes) / bytesInMegabyte, 0, 'f', 1)
        .arg(pathText(backup.file.filename()),
             backup.isByDate ? QString() : QStringLiteral("  (before an update)"));
}

Result<void> makeBackup(const CommandCall &call)
{
    int days = 0;
    if (call.isSet(option::keep)) {
        bool isWhole = false;
        days = QString::fromStdString(call.value(option::keep)).toInt(&isWhole);
        if (!isWhole || days < BackupPlan::fewestDays || days > BackupPlan::mostDays)
            return call.wrongCall(ODO_TEXT("app.keep_takes_days", "--keep takes %1 to %2 days")(
                BackupPlan::fewestDays, BackupPlan::mostDays));
    }
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadOnly));
    const Instant now = backupTime();
    const auto made = ODO_TRY(backUp(*project, now));
    const int removed = days > 0 ? removeOldBackups(project->file(), days, now) : 0;
    QJsonObject json = backupJson(made);
    json.insert(QStringLiteral("removed"), removed);
    QString text = QStringLiteral("Backed up to %1. Videos are not part of it.").arg(pathText(made.file));
    if (removed > 0)
        text += QStringLiteral(" Older backups removed: %1.").arg(removed);
    call.answer(json, text);
    return {};
}

Result<void> listBackups(const CommandCall &call)
{
    QJsonArray json;
    QStringList lines(
        QStringLiteral("Backups in %1").arg(pathText(backupFolderOf(std::filesystem::path(call.text(1))))));
    for (const ProjectBackup &backup : backupsOf(call.text(1))) {
        json.append(backupJson(backup));
        lines << QStringLiteral("  ") + backupLine(backup);
    }
    if (json.isEmpty())
        lines << QStringLiteral("  none yet");
    call.answer({{QStringLiteral("folder"), pathText(backupFolderOf(std::filesystem::path(call.text(1))))},
                 {QStringLiteral("backups"), json}},
                lines.join(u'\n'));
    return {};
}

/// The backup with the file name that was given.
Result<ProjectBackup> chosenBackup(const CommandCall &call)
{
    for (const ProjectBackup &backup : backupsOf(call.text(1)))
        if (backup.file.filename() == std::filesystem::path(call.text(2)).filename())
            return backup;
    return fail(ErrorCode::NotFound, ODO_TEXT("app.backup_called", "backup '%1'")(Named::file(call.text(2))),
                ODO_TEXT("app.no_such_backup", "the project has none of that name"),
                ODO_TEXT("app.list_backups", "odograph backup list names them"));
}

Result<void> showBackup(const CommandCall &call)
{
    const auto backup = ODO_TRY(chosenBackup(call));
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadOnly));
    const auto preview = ODO_TRY(previewBackup(backup.file, *project));
    QStringList lines(backupLine(backup));
    lines << QStringLiteral("  %1").arg(counted(preview.trialCount, QStringLiteral("trial")));
    const auto addNames = [&lines](const QString &words, const std::vector<std::string> &names) {
        for (const std::string &name : names)
            lines << words.arg(QString::fromStdString(name));
    };
    addNames(QStringLiteral("  without trial %1"), preview.trialsLost);
    addNames(QStringLiteral("  with trial %1, which the project no longer has"), preview.trialsBack);
    if (preview.videosMissing > 0)
        lines << QStringLiteral("  %1 missing").arg(counted(preview.videosMissing, QStringLiteral("video")));
    QJsonArray lost, back;
    for (const ChangeEntry &change : preview.changesLost) {
        lost.append(english(change.words));
        lines << QStringLiteral("  before: %1  %2").arg(dateText(change.made), english(change.words));
    }
    for (const ChangeEntry &change : preview.changesBack)
        back.append(english(change.words));
    QJsonObject json = backupJson(backup);
    json.insert(QStringLiteral("title"), QString::fromStdString(preview.title));
    json.insert(QStringLiteral("trials"), qint64(preview.trialCount));
    json.insert(QStringLiteral("trials_lost"), namesJson(preview.trialsLost));
    json.insert(QStringLiteral("trials_back"), namesJson(preview.trialsBack));
    json.insert(QStringLiteral("changes_lost"), lost);
    json.insert(QStringLiteral("changes_back"), back);
    json.insert(QStringLiteral("videos_missing"), qint64(preview.videosMissing));
    call.answer(json, lines.join(u'\n'));
    return {};
}

Result<void> restoreFromBackup(const CommandCall &call)
{
    const std::filesystem::path project = call.text(1);
    const auto backup = ODO_TRY(chosenBackup(call));
    const auto lock = ODO_TRY(WindowLock::take(project)); // no window has it open meanwhile
    const auto kept = ODO_TRY(goBackTo(backup.file, project, backupTime()));
    call.answer({{QStringLiteral("project"), call.positional(1)},
                 {QStringLiteral("backup"), pathText(backup.file)},
                 {QStringLiteral("kept"), pathText(kept)}},
                QStringLiteral("%1 is as of %2. What it was until now is kept as %3.")
                    .arg(call.positional(1), dateText(backup.made), pathText(kept)));
    return {};
}

} // namespace

Result<void> runBackup(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("backup"),
                      QStringLiteral("make P.odo [--keep DAYS] | list P.odo | show P.odo BACKUP | "
                                     "restore P.odo BACKUP [--json]"),
                      2,
                      3,
                      {{option::keep, QStringLiteral("Removes backups that are older than so many days."),
                        QStringLiteral("DAYS")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const QString verb = call.positional(0);
    const auto count = call.positionals().size();
    if (verb == QStringLiteral("make") && count == 2)
        return makeBackup(call);
    if (verb == QStringLiteral("list") && count == 2)
        return listBackups(call);
    if (verb == QStringLiteral("show") && count == 3)
        return showBackup(call);
    if (verb == QStringLiteral("restore") && count == 3)
        return restoreFromBackup(call);
    return call.wrongCall(ODO_TEXT(
        "app.backup_verbs", "give make P.odo, list P.odo, show P.odo BACKUP, or restore P.odo BACKUP"));
}

} // namespace odo
