// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/check_repairs.h"

#include "app/option_names.h"
#include "core/workflow/relink_job.h"
#include "core/workflow/stray_jobs.h"

#include <QJsonArray>

namespace odo {

namespace {

Result<void> findLost(const CommandCall &call, Project &project, MediaRepairs &repairs)
{
    RelinkJob job(call.value(option::find));
    const auto done = runToEnd(job, project, call.control());
    if (!done && done.error().code != ErrorCode::NotFound)
        return done;
    if (!done)
        CommandCall::warn(done.error().message());
    repairs.json.insert(QStringLiteral("found"), qint64(job.foundCount()));
    repairs.lines << QStringLiteral("Lost videos found by their content: %1 of %2").arg(job.foundCount()).arg(job.lostCount());
    return {};
}

Result<void> adopt(const CommandCall &call, Project &project, const FindStraysJob &found, MediaRepairs &repairs)
{
    AdoptStraysJob job(found.videos());
    if (auto done = runToEnd(job, project, call.control()); !done)
        return done;
    QJsonArray trials;
    for (const std::string &name : job.trials()) {
        trials.append(QString::fromStdString(name));
        repairs.lines << QStringLiteral("Trial %1 added").arg(QString::fromStdString(name));
    }
    repairs.json.insert(QStringLiteral("adopted"), trials);
    for (const Error &failure : job.failures())
        CommandCall::warn(failure.message());
    return {};
}

Result<void> remove(const CommandCall &call, Project &project, const FindStraysJob &found, MediaRepairs &repairs)
{
    RemoveStraysJob job(found.strays());
    if (auto done = runToEnd(job, project, call.control()); !done)
        return done;
    QJsonArray files;
    for (const std::filesystem::path &file : job.removed()) {
        files.append(QString::fromStdString(file.string()));
        repairs.lines << QStringLiteral("File %1 removed").arg(QString::fromStdString(file.string()));
    }
    for (const std::filesystem::path &file : found.others())
        repairs.lines << QStringLiteral("File %1 stays").arg(QString::fromStdString(file.string()));
    repairs.json.insert(QStringLiteral("removed"), files);
    return {};
}

} // namespace

QList<QCommandLineOption> repairOptions()
{
    return {{option::find, QStringLiteral("Finds lost videos in this folder or below, by size and content, and takes them from there."),
             QStringLiteral("FOLDER")},
            {option::adopt, QStringLiteral("Makes trials of videos in the media folder that belong to none.")},
            {option::removeStrays, QStringLiteral("Removes the files in the media folder that belong to nothing in the project.")}};
}

bool asksForRepairs(const CommandCall &call)
{
    return call.isSet(option::find) || call.isSet(option::adopt) || call.isSet(option::removeStrays);
}

Result<MediaRepairs> repairMedia(const CommandCall &call, Project &project)
{
    MediaRepairs repairs;
    if (call.isSet(option::find)) {
        if (auto found = findLost(call, project, repairs); !found)
            return tl::unexpected(found.error());
    }
    for (const auto &[name, mend] : {std::pair{option::adopt, &adopt}, std::pair{option::removeStrays, &remove}}) {
        if (!call.isSet(name))
            continue;
        FindStraysJob strays;
        auto done = runToEnd(strays, project, call.control());
        if (done)
            done = mend(call, project, strays, repairs);
        if (!done)
            return tl::unexpected(done.error());
    }
    return repairs;
}

} // namespace odo
