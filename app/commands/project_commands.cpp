// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/commands/trial_commands.h"
#include "app/workbench.h"
#include "core/project/names.h"
#include "core/project/repositories.h"
#include "core/workflow/demo.h"
#include "core/workflow/media_upkeep.h"
#include "core/workflow/track/trial_verdict.h"
#include "core/workflow/turned_recordings.h"

#include <QJsonArray>

namespace odo {

Result<void> runNew(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("new"),
         QStringLiteral("P.odo [--title TEXT]"),
         1,
         1,
         {{QStringLiteral("title"), QStringLiteral("What the project is called."), QStringLiteral("TEXT")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const std::filesystem::path file = call.text(0);
    const std::string title =
        call.isSet(QStringLiteral("title")) ? call.value(QStringLiteral("title")) : titleFromName(file);
    const auto project = ODO_TRY(Project::create(file, title));
    const auto stored = ODO_TRY(project->title());
    call.answer({{QStringLiteral("project"), call.positional(0)},
                 {QStringLiteral("title"), QString::fromStdString(stored)}},
                QStringLiteral("Made %1.").arg(call.positional(0)));
    return {};
}

Result<void> runDemo(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("demo"),
                      QStringLiteral("DIR [--open]"),
                      1,
                      1,
                      {{option::open, QStringLiteral("Open the workbench with it.")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto file = ODO_TRY(makeDemo(call.text(0), call.control()));
    const QString path = QString::fromStdString(file.string());
    call.answer({{QStringLiteral("project"), path}}, QStringLiteral("The demo lesson is in %1.").arg(path));
    if (call.isSet(option::open))
        runWorkbench(file);
    return {};
}

/// What was done about files that are lost or belong to nobody.
struct MediaRepairs
{
    QJsonObject json;
    QStringList lines;
};

namespace {

Result<void> findLost(const CommandCall &call, Project &project, MediaRepairs &repairs)
{
    RelinkJob job(call.value(option::find));
    const auto done = runToEnd(job, project, call.control());
    if (!done && done.error().code != ErrorCode::NotFound)
        return done;
    if (!done)
        CommandCall::warnOf(done.error());
    repairs.json.insert(QStringLiteral("found"), qint64(job.foundCount()));
    repairs.lines << QStringLiteral("Lost videos found by their content: %1 of %2")
                         .arg(job.foundCount())
                         .arg(job.lostCount());
    return {};
}

Result<void> adopt(const CommandCall &call, Project &project, const FindStraysJob &found,
                   MediaRepairs &repairs)
{
    AdoptStraysJob job(found.videos());
    ODO_TRY(runToEnd(job, project, call.control()));
    QJsonArray trials;
    for (const std::string &name : job.trials()) {
        trials.append(QString::fromStdString(name));
        repairs.lines << QStringLiteral("Trial %1 added").arg(QString::fromStdString(name));
    }
    repairs.json.insert(QStringLiteral("adopted"), trials);
    for (const Error &failure : job.failures())
        CommandCall::warnOf(failure);
    return {};
}

Result<void> remove(const CommandCall &call, Project &project, const FindStraysJob &found,
                    MediaRepairs &repairs)
{
    RemoveStraysJob job(found.strays());
    ODO_TRY(runToEnd(job, project, call.control()));
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

/// The options of odograph check that change something.
QList<QCommandLineOption> repairOptions()
{
    return {{option::find,
             QStringLiteral("Finds lost videos in this folder and its subfolders, by size and content, and "
                            "uses them from there."),
             QStringLiteral("FOLDER")},
            {option::adopt,
             QStringLiteral("Creates trials for videos in the media folder that belong to no trial.")},
            {option::removeStrays,
             QStringLiteral("Removes the files in the media folder that belong to nothing in the project.")}};
}

/// Whether any of them is set.
bool asksForRepairs(const CommandCall &call)
{
    return call.isSet(option::find) || call.isSet(option::adopt) || call.isSet(option::removeStrays);
}

/// As the options ask: finds lost videos by their content, makes trials of stray ones, removes stray files.
/// The project is open to write.
Result<MediaRepairs> repairMedia(const CommandCall &call, Project &project)
{
    MediaRepairs repairs;
    if (call.isSet(option::find))
        ODO_TRY(findLost(call, project, repairs));
    for (const auto &[name, mend] :
         {std::pair{option::adopt, &adopt}, std::pair{option::removeStrays, &remove}}) {
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

namespace {

/// What was repaired before the check was stopped stays repaired.
tl::unexpected<Error> stopped(Error error, bool repairs)
{
    if (repairs && error.code == ErrorCode::Cancelled)
        error.advice = ODO_TEXT("app.repairs_kept", "what was repaired until then is kept");
    return tl::unexpected(std::move(error));
}

} // namespace

Result<void> runCheck(const QStringList &arguments, const CancelToken &cancel)
{
    const QString quick = QStringLiteral("quick");
    QList<QCommandLineOption> options = repairOptions();
    options.prepend(
        {quick, QStringLiteral("Skips the content of the recordings, and metrics proven by their digests.")});
    CommandCall call({QStringLiteral("check"),
                      QStringLiteral("P.odo [--quick] [--find FOLDER] [--adopt] [--remove-strays] [--json]"),
                      1, 1, options},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const bool repairs = asksForRepairs(call);
    const auto project =
        ODO_TRY(call.openProject(0, repairs ? Project::Access::ReadWrite : Project::Access::ReadOnly));
    const auto repaired = repairs ? repairMedia(call, *project) : MediaRepairs();
    if (!repaired)
        return stopped(repaired.error(), repairs);
    auto problems = project->check(!call.isSet(quick), call.control());
    if (!problems)
        return stopped(problems.error(), repairs);
    if (const auto turned = turnedRecordings(*project, call.isSet(quick) ? Opened::NeverTurned : Opened::All))
        problems->insert(problems->end(), turned->begin(), turned->end());
    const auto unproved = ODO_TRY(project->analyses().countWithoutDigest());
    QJsonArray list;
    QStringList lines = repaired->lines;
    QJsonObject json = repaired->json;
    for (const ProjectProblem &problem : *problems) {
        list.append(QJsonObject{{QStringLiteral("what"), english(problem.what)},
                                {QStringLiteral("where"), english(problem.where)},
                                {QStringLiteral("advice"), english(problem.advice)}});
        lines << english(wholeMessage(problem.where, problem.what, problem.advice));
    }
    if (problems->empty())
        lines << QStringLiteral("No problems found.");
    if (unproved > 0)
        lines << QStringLiteral("Analyses without a digest: %1. Each was made by an older Odograph, or its "
                                "digest was removed. Analysing a trial again adds one.")
                     .arg(unproved);
    json.insert(QStringLiteral("ok"), problems->empty());
    json.insert(QStringLiteral("problems"), list);
    json.insert(QStringLiteral("without_digest"), qint64(unproved));
    call.answer(json, lines.join(u'\n'));
    if (!problems->empty())
        return fail(
            ErrorCode::InvalidInput, ODO_TEXT("app.check_of", "check of '%1'")(Named::file(call.text(0))),
            problems->size() == 1 ? Message(ODO_TEXT("app.problem_found", "1 problem found"))
                                  : ODO_TEXT("app.problems_found", "%1 problems found")(problems->size()),
            ODO_TEXT("app.follow_advice", "follow the advice given with each"));
    return {};
}

Result<void> runList(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("list"), QStringLiteral("P.odo [--json]"), 1, 1, {}}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const auto title = ODO_TRY(project->title());
    const auto all = ODO_TRY(project->trials().all());
    const auto verdicts = ODO_TRY(project->verdicts().all(Instant::min(), Instant::max()));
    QJsonArray trials;
    QStringList lines(QString::fromStdString(title));
    for (const TrialRecord &trial : all) {
        QJsonArray robots;
        for (const std::string &robot : trial.robotNames)
            robots.append(QString::fromStdString(robot));
        const auto verdict = verdicts.find(trial.id);
        const bool isChecked = verdict != verdicts.end();
        trials.append(QJsonObject{
            {QStringLiteral("name"), QString::fromStdString(trial.name)},
            {QStringLiteral("team"), QString::fromStdString(trial.teamName)},
            {QStringLiteral("task"), QString::fromStdString(trial.task)},
            {QStringLiteral("date"), dateText(trial.date)},
            {QStringLiteral("robots"), robots},
            {QStringLiteral("duration_s"), trial.durationS},
            {QStringLiteral("views"), trial.viewCount},
            {QStringLiteral("verdict"), isChecked ? verdictLevelJson(verdict->second) : QJsonValue()}});
        lines << QStringLiteral("  %1  %2  %3  %4 s  %5%6")
                     .arg(QString::fromStdString(trial.name), -24)
                     .arg(QString::fromStdString(trial.teamName), -16)
                     .arg(dateText(trial.date))
                     .arg(trial.durationS, 0, 'f', 2)
                     .arg(counted(trial.viewCount, QStringLiteral("view")))
                     .arg(isChecked ? QStringLiteral("  ") + QString::fromStdString(wordOf(verdict->second))
                                    : QString());
    }
    call.answer(
        {{QStringLiteral("title"), QString::fromStdString(title)}, {QStringLiteral("trials"), trials}},
        lines.join(u'\n'));
    return {};
}

} // namespace odo
