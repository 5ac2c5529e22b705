// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/school_sync.h"

#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/commands/hub_argument.h"
#include "core/base/file_system.h"
#include "core/project/project.h"
#include "core/school/hub_results.h"

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

Result<void> initialise(const CommandCall &call)
{
    const auto address = ODO_TRY(hubAddressAt(call, 1));
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
    const auto address = ODO_TRY(hubAddressAt(call, 2));
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    std::string folder;
    if (call.isSet(option::media))
        folder = files::absolute(call.value(option::media)).string();
    const auto link = ODO_TRY(connectToSchool(*project, address, folder));
    const auto pending = ODO_TRY(project->school().pending());
    call.answer(linkJson(link, pending), linkText(link, pending));
    return {};
}

Result<void> showStatus(const CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadOnly));
    const SchoolRepository &school = project->school();
    const auto link = ODO_TRY(schoolLink(school));
    const auto pending = ODO_TRY(school.pending());
    call.answer(linkJson(link, pending), linkText(link, pending));
    return {};
}

Result<void> disconnectProject(const CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    SchoolRepository &school = project->school();
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
                                                   const JobControl &control, const SchoolContact &contact))
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    const auto recordings = call.isSet(option::recordings) ? WithRecordings::Yes : WithRecordings::No;
    const auto report = ODO_TRY(work(*project, recordings, call.control(), {}));
    answerReport(call, report);
    return {};
}

/// A page at a time, so no hub is too large.
Result<std::vector<HubRun>> newestRuns(HubResults &hub, const HubRunFilter &filter, const CommandCall &call)
{
    constexpr std::size_t most = 1000;
    constexpr int page = 250;
    std::vector<HubRun> runs;
    while (runs.size() < most && !call.control().isCancelled()) {
        auto more = ODO_TRY(hub.runs(filter, page, runs.empty() ? nullptr : &runs.back()));
        runs.insert(runs.end(), more.begin(), more.end());
        if (int(more.size()) < page)
            break;
    }
    return runs;
}

QJsonObject runJson(const HubRun &run)
{
    const auto text = [](const std::string &value) { return QString::fromStdString(value); };
    QJsonObject json{
        {QStringLiteral("trial"), text(run.name)},        {QStringLiteral("uuid"), text(run.trial)},
        {QStringLiteral("robot"), text(run.robot)},       {QStringLiteral("team"), text(run.team)},
        {QStringLiteral("class"), text(run.className)},   {QStringLiteral("task"), text(run.task)},
        {QStringLiteral("date"), dateText(run.held)},     {QStringLiteral("duration_s"), run.durationS},
        {QStringLiteral("standing"), text(run.standing)}, {QStringLiteral("bench"), text(run.bench)}};
    if (run.metric) {
        json[QStringLiteral("value")] = run.metric->value;
        json[QStringLiteral("unit")] = text(run.metric->unit);
        json[QStringLiteral("sigma")] =
            run.metric->sigma ? QJsonValue(*run.metric->sigma) : QJsonValue(QJsonValue::Null);
    }
    return json;
}

QString runText(const HubRun &run)
{
    QStringList parts{dateText(run.held)};
    for (const std::string &part : {run.name, run.robot, run.team, run.className, run.task})
        parts << QString::fromStdString(part.empty() ? "-" : part);
    if (run.metric)
        parts << QStringLiteral("%1 %2").arg(run.metric->value).arg(QString::fromStdString(run.metric->unit));
    return parts.join(QStringLiteral("  "));
}

Result<void> listRuns(const CommandCall &call)
{
    const auto address = ODO_TRY(hubAddressAt(call, 1));
    const HubRunFilter filter{call.value(option::search), call.value(option::ofClass),
                              call.value(option::team),   call.value(option::task),
                              call.value(option::metric), call.value(option::bench)};
    constexpr std::size_t shortestSearch = 3; // letters, of which an index is made
    if (!filter.search.empty() && QString::fromStdString(filter.search).size() < qsizetype(shortestSearch))
        return call.wrongCall(ODO_TEXT("app.search_is_longer", "--search needs three letters at least"));
    const auto hub = ODO_TRY(HubResults::connect(address));
    const auto runs = ODO_TRY(newestRuns(*hub, filter, call));
    QJsonArray list;
    QStringList lines{counted(int(runs.size()), QStringLiteral("run"))};
    for (const HubRun &run : runs) {
        list.append(runJson(run));
        lines << runText(run);
    }
    call.answer({{QStringLiteral("runs"), list}}, lines.join(u'\n'));
    return {};
}

} // namespace

Result<void> runSchool(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("school"),
         QStringLiteral("init URL | connect P.odo URL [--media FOLDER] | publish P.odo [--recordings] | "
                        "pull P.odo [--recordings] | status P.odo | disconnect P.odo | list URL "
                        "[--search TEXT] [--class CLASS] [--team TEAM] [--task TASK] [--bench LOGIN] "
                        "[--metric METRIC] [--json]"),
         2,
         3,
         {{option::search, QStringLiteral("Runs with this text in the name of the trial or of the team."),
           QStringLiteral("TEXT")},
          {option::ofClass, QStringLiteral("Runs of this class."), QStringLiteral("CLASS")},
          {option::team, QStringLiteral("Runs of this team, by the name that viewers see."),
           QStringLiteral("TEAM")},
          {option::task, QStringLiteral("Runs of this task."), QStringLiteral("TASK")},
          {option::bench, QStringLiteral("Runs that this login published."), QStringLiteral("LOGIN")},
          {option::metric, QStringLiteral("The metric to list of each run."), QStringLiteral("METRIC")},
          {option::media, QStringLiteral("The school's folder of recordings."), QStringLiteral("FOLDER")},
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
    for (const QString &one :
         {option::search, option::ofClass, option::team, option::task, option::bench, option::metric})
        if (call.isSet(one) && verb != QStringLiteral("list"))
            return call.wrongCall(ODO_TEXT("app.goes_with_list", "--%1 goes with list")(one.toStdString()));
    if (verb == QStringLiteral("list") && count == 2)
        return listRuns(call);
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
                                   "give init URL, list URL, connect P.odo URL, or publish, pull, "
                                   "status or disconnect P.odo"));
}

} // namespace odo
