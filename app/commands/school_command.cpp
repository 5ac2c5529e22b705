// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/school_sync.h"

#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/base/file_system.h"
#include "core/project/class_repository.h"
#include "core/project/project.h"

#include <QJsonArray>

namespace odo {

namespace {

QJsonObject conflictJson(const SchoolConflict &conflict)
{
    return {{QStringLiteral("kind"), QString::fromStdString(schoolKindWord(conflict.kind))},
            {QStringLiteral("name"), QString::fromStdString(conflict.name)},
            {QStringLiteral("uuid"), QString::fromStdString(conflict.uuid)},
            {QStringLiteral("in_force"),
             conflict.isOursInForce ? QStringLiteral("ours") : QStringLiteral("theirs")},
            {QStringLiteral("ours"), conflict.ours},
            {QStringLiteral("theirs"), conflict.theirs}};
}

void answerReport(const CommandCall &call, const SchoolReport &report)
{
    QJsonArray conflicts;
    QStringList lines{QStringLiteral("%1 sent, %2 received, %3 pending")
                          .arg(report.sent)
                          .arg(report.received)
                          .arg(report.pending)};
    for (const SchoolConflict &conflict : report.conflicts) {
        conflicts.append(conflictJson(conflict));
        lines << QStringLiteral(
                     "Conflict: %1 was changed here and elsewhere; %2 in force, the other version is kept")
                     .arg(english(schoolDocumentSubject(conflict.kind, conflict.name)),
                          conflict.isOursInForce ? QStringLiteral("this one is")
                                                 : QStringLiteral("the hub's is"));
    }
    for (const Message &warning : report.warnings)
        CommandCall::warn(warning);
    call.answer({{QStringLiteral("sent"), report.sent},
                 {QStringLiteral("received"), report.received},
                 {QStringLiteral("conflicts"), conflicts},
                 {QStringLiteral("media_bytes"), qint64(report.mediaBytes)},
                 {QStringLiteral("pending"), qint64(report.pending)}},
                lines.join(u'\n'));
}

Result<HubAddress> addressAt(const CommandCall &call, int index)
{
    auto address = HubAddress::parse(call.text(index));
    if (!address)
        return fail(ErrorCode::WrongCall, address.error().what, address.error().why, address.error().advice);
    return address;
}

Result<void> initialise(const CommandCall &call)
{
    const auto address = ODO_TRY(addressAt(call, 1));
    const auto version = ODO_TRY(initialiseHub(address));
    call.answer(
        {{QStringLiteral("url"), QString::fromStdString(address.url())},
         {QStringLiteral("schema_version"), version}},
        QStringLiteral("The hub is ready, schema version %1, with the roles teacher, bench and viewer.")
            .arg(version));
    return {};
}

QString linkText(const SchoolLink &link, std::int64_t pending)
{
    return QStringLiteral("Connected to %1 as %2, %3 pending, last contact %4")
        .arg(QString::fromStdString(link.url), QString::fromStdString(link.role))
        .arg(pending)
        .arg(link.lastSync ? dateText(*link.lastSync) : QStringLiteral("never"));
}

QJsonObject linkJson(const SchoolLink &link, std::int64_t pending)
{
    return {
        {QStringLiteral("url"), QString::fromStdString(link.url)},
        {QStringLiteral("role"), QString::fromStdString(link.role)},
        {QStringLiteral("schema_version"), link.schemaVersion},
        {QStringLiteral("last_sync"), link.lastSync ? QJsonValue(dateText(*link.lastSync)) : QJsonValue()},
        {QStringLiteral("pending"), qint64(pending)}};
}

Result<void> connectProject(const CommandCall &call)
{
    const auto address = ODO_TRY(addressAt(call, 2));
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    std::string folder;
    if (call.isSet(option::media))
        folder = files::absolute(call.value(option::media)).string();
    const auto link = ODO_TRY(connectToSchool(*project, address, folder));
    const auto pending = ODO_TRY(project->classes().school().pending());
    call.answer(linkJson(link, pending), linkText(link, pending));
    return {};
}

Result<void> showStatus(const CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadOnly));
    const SchoolRepository school = project->classes().school();
    const auto link = ODO_TRY(schoolLink(school));
    const auto pending = ODO_TRY(school.pending());
    call.answer(linkJson(link, pending), linkText(link, pending));
    return {};
}

Result<void> disconnectProject(const CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    SchoolRepository school = project->classes().school();
    const auto link = ODO_TRY(schoolLink(school));
    const auto pending = ODO_TRY(school.pending());
    ODO_TRY(school.disconnect());
    call.answer({{QStringLiteral("url"), QString::fromStdString(link.url)},
                 {QStringLiteral("pending"), qint64(pending)}},
                QStringLiteral("Disconnected from %1; %2 not sent, everything stays in the project.")
                    .arg(QString::fromStdString(link.url), counted(pending, QStringLiteral("change"))));
    return {};
}

Result<void> exchange(const CommandCall &call,
                      Result<SchoolReport> (*work)(Project &project, WithRecordings recordings,
                                                   const JobControl &control))
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    const auto recordings = call.isSet(option::recordings) ? WithRecordings::Yes : WithRecordings::No;
    const auto report = ODO_TRY(work(*project, recordings, call.control()));
    answerReport(call, report);
    return {};
}

} // namespace

Result<void> runSchool(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("school"),
         QStringLiteral("init URL | connect P.odo URL [--media FOLDER] | publish P.odo [--recordings] | "
                        "pull P.odo [--recordings] | status P.odo | disconnect P.odo [--json]"),
         2,
         3,
         {{option::media, QStringLiteral("The school's folder of recordings."), QStringLiteral("FOLDER")},
          {option::recordings, QStringLiteral("Copy recordings to the media folder, or from it, too.")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const QString verb = call.positional(0);
    const auto count = call.positionals().size();
    if (call.isSet(option::media) && verb != QStringLiteral("connect"))
        return call.wrongCall(ODO_TEXT("app.media_with_connect", "--media goes with connect"));
    if (call.isSet(option::recordings) && verb != QStringLiteral("publish") && verb != QStringLiteral("pull"))
        return call.wrongCall(
            ODO_TEXT("app.recordings_with_publish", "--recordings goes with publish and pull"));
    if (verb == QStringLiteral("connect") && count == 3)
        return connectProject(call);
    if (verb == QStringLiteral("init") && count == 2)
        return initialise(call);
    if (verb == QStringLiteral("publish") && count == 2)
        return exchange(call, publishToSchool);
    if (verb == QStringLiteral("pull") && count == 2)
        return exchange(call, pullFromSchool);
    if (verb == QStringLiteral("status") && count == 2)
        return showStatus(call);
    if (verb == QStringLiteral("disconnect") && count == 2)
        return disconnectProject(call);
    return call.wrongCall(ODO_TEXT("app.school_verbs",
                                   "give init URL, connect P.odo URL, or publish, pull, status or "
                                   "disconnect P.odo"));
}

} // namespace odo
