// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/trial_commands.h"

#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/analysis/metrics.h"
#include "core/base/error.h"
#include "core/project/names.h"
#include "core/project/repositories.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/shared_words.h"

#include <cmath>
#include <map>
#include <optional>

namespace odo {

namespace {

std::optional<SyncBy> namedSync(const std::string &name)
{
    using Sync = SyncBy;
    static const std::map<std::string, Sync> names{{"auto", Sync::Automatic},
                                                   {"motion", Sync::Motion},
                                                   {"flash", Sync::Flash},
                                                   {"audio", Sync::Sound},
                                                   {"none", Sync::None}};
    const auto found = names.find(name);
    return found != names.end() ? std::optional(found->second) : std::nullopt;
}

} // namespace

Result<std::vector<ViewStep>> stepsOf(const CommandCall &call)
{
    std::vector<ViewStep> steps;
    for (const QString &text :
         QString::fromStdString(call.value(option::sync)).split(u',', Qt::SkipEmptyParts)) {
        const std::string how = text.trimmed().toStdString();
        if (const auto named = namedSync(how)) {
            steps.push_back({*named, 0});
            continue;
        }
        const auto offset = parseNumber(how);
        if (!offset)
            return call.wrongCall(
                ODO_TEXT("app.sync_is",
                         "--sync is auto, motion, flash, audio, none or seconds, one for each view but the "
                         "first"));
        if (std::abs(*offset) > largestOffsetS)
            return call.wrongCall(
                ODO_TEXT("app.sync_takes_seconds", "--sync takes seconds from -3600 to 3600"));
        steps.push_back({SyncBy::Given, *offset});
    }
    return steps;
}

namespace {

Result<ImportSettings> importSettings(const CommandCall &call)
{
    ImportSettings settings;
    if (!call.isSet(option::trial) || !call.isSet(option::video))
        return call.wrongCall(
            ODO_TEXT("app.import_needs", "--trial and --video, or --trial and --track, are needed"));
    settings.trial = call.value(option::trial);
    const auto videos = ODO_TRY(call.pairs(option::video));
    for (const auto &[camera, file] : videos)
        settings.videos.emplace_back(camera, file);
    const auto times = ODO_TRY(call.pairs(option::times));
    for (const auto &[camera, table] : times)
        settings.times.emplace_back(camera, table);
    settings.timeUnit = ODO_TRY(timeUnitOf(call));
    settings.steps = ODO_TRY(stepsOf(call));
    settings.team = call.value(option::team);
    settings.task = call.value(option::task);
    settings.robots = call.texts(option::robot);
    if (call.isSet(option::rate)) {
        settings.rate = ODO_TRY(frameRateOf(call));
    }
    return settings;
}

/// Those that belong to a team; none where it is new.
std::vector<std::string> robotsOfTeam(Project &project, const std::string &name)
{
    std::vector<std::string> names;
    if (const auto known = project.teams().find(name))
        for (const RecordId id : known->robots)
            if (const auto its = project.robots().get(id))
                names.push_back(its->name);
    return names;
}

} // namespace

Result<void> runImport(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("import"),
         QStringLiteral(
             "P.odo --trial NAME --video A=a.mp4 [--video B=b.mp4]... [--times A=stamps.csv]... "
             "[--sync auto|motion|flash|audio|none|SECONDS[,...]] [--team T] [--task TASK] [--robot R]... "
             "[--rate 240] [--json] "
             "| "
             "P.odo --trial NAME --track R=FILE|-... [--team T] [--task TASK] [--unit "
             "UNIT] "
             "[--time-unit UNIT] [--axes xz] [--min-confidence 0.6] [--sigma 5mm] [--rate 30] [--pixel 2mm] "
             "[--decimal comma] [--json]"),
         1, 1,
         QList<QCommandLineOption>{
             {option::trial, QStringLiteral("What the trial is called."), QStringLiteral("NAME")},
             {option::video,
              QStringLiteral(
                  "A view: the camera's name and the file; FILE+FILE: the chapters of one recording; "
                  "FOLDER or FOLDER/%06d.png: numbered images."),
              QStringLiteral("CAMERA=FILE")},
             {option::times,
              QStringLiteral(
                  "When the frames of a view were taken: a table with one time for each, in place of "
                  "the file's own times."),
              QStringLiteral("CAMERA=FILE")},
             {option::track,
              QStringLiteral(
                  "A robot's finished track in place of videos: TUM, CSV, Tracker text and others; - reads "
                  "standard input."),
              QStringLiteral("ROBOT=FILE|-")},
             {option::sync,
              QStringLiteral(
                  "How much later each other view's first frame was taken than the first view's; "
                  "auto: found by the motion, a flash of light or a clap, whichever is most precise."),
              QStringLiteral("auto|motion|flash|audio|none|SECONDS[,...]")},
             {option::team, QStringLiteral("The team of the trial."), QStringLiteral("T")},
             {option::task, QStringLiteral("The task of the trial; see odograph task add."),
              QStringLiteral("TASK")},
             {option::robot, QStringLiteral("A robot in view; default: the team's robots."),
              QStringLiteral("R")},
             {option::rate,
              QStringLiteral(
                  "The camera's frame rate, if the file says another, or a track only frame numbers; of "
                  "images, the rate of their numbers."),
              QStringLiteral("FPS")}} +
             trackReadingOptions()},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (call.isSet(option::track))
        return importTracks(call);
    ODO_TRY(refuseTrackOptions(call));
    auto settings = ODO_TRY(importSettings(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    if (!settings.task.empty())
        ODO_TRY(project->tasks().find(settings.task));
    if (settings.robots.empty() && !settings.team.empty())
        settings.robots = robotsOfTeam(*project, settings.team);
    ImportTrialJob job(std::move(settings));
    if (auto done = runToEnd(job, *project, call.control()); !done) {
        done.error().advice = adviceAsOption(done.error().advice);
        return done;
    }
    QJsonObject views;
    for (std::size_t i = 0; i < job.recordings().size(); ++i) {
        const RecordingRecord &recording = job.recordings()[i];
        const ViewCoding &coding = job.codings()[i];
        QJsonObject view = recordingJson(recording);
        view.insert(QStringLiteral("codec"), QString::fromStdString(coding.codec));
        view.insert(QStringLiteral("bit_depth"), coding.bitDepth);
        view.insert(QStringLiteral("variable_rate"), coding.variableRate);
        views.insert(QString::fromStdString(recording.cameraName), view);
    }
    call.answer({{QStringLiteral("trial"), QString::fromStdString(job.trial().name)},
                 {QStringLiteral("views"), views},
                 {QStringLiteral("sync"), syncJson(job.trial())}},
                (QStringList(QStringLiteral("Trial %1 imported, views: %2")
                                 .arg(QString::fromStdString(job.trial().name))
                                 .arg(job.recordings().size()))
                 << stepSentences(job.recordings()))
                    .join(u'\n'));
    for (const Message &warning : job.warnings())
        CommandCall::warn(warning);
    return {};
}

} // namespace odo
