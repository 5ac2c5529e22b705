// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/trial_commands.h"

#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/analysis/metrics.h"
#include "core/base/error.h"
#include "core/base/percentile.h"
#include "core/base/platform/sleep_inhibitor.h"
#include "core/project/names.h"
#include "core/project/repositories.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/record/record_trial.h"
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

namespace {

/// Opening has completed what was cut off, and said so.
Result<void> answerRecover(const CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    const auto trials = ODO_TRY(project->trials().names());
    if (const auto left = std::ranges::find_if(trials, &TrialName::unfinished); left != trials.end())
        return fail(ErrorCode::InvalidInput, trialSubject(left->name),
                    ODO_TEXT("app.cut_off", "its recording was cut off; it is not complete yet"),
                    ODO_TEXT("app.follow_above", "follow the advice above"));
    call.answer({{QStringLiteral("project"), call.positional(0)}},
                QStringLiteral("No recording is left that was cut off."));
    return {};
}

Result<RecordSettings> recordSettings(const CommandCall &call)
{
    if (!call.isSet(option::trial))
        return call.missing(option::trial);
    if (!call.isSet(option::camera))
        return call.missing(option::camera);
    auto cameras = ODO_TRY(call.pairs(option::camera));
    RecordSettings settings;
    settings.trial = call.value(option::trial);
    settings.cameras = std::move(cameras);
    settings.robots = call.texts(option::robot);
    if (call.isSet(option::seconds)) {
        const auto number = call.number(option::seconds);
        if (!number || *number <= 0 || *number > longestRecordingS)
            return call.wrongCall(
                ODO_TEXT("app.seconds_is", "--seconds is a number above zero, at most 86,400 (a day)"));
        settings.seconds = *number;
    }
    if (call.isSet(option::sslVision)) {
        settings.broadcast = ODO_TRY(parseBroadcastTarget(call.value(option::sslVision)));
    }
    if (call.isSet(option::preRoll)) {
        const auto number = call.number(option::preRoll);
        if (!number || *number < 0 || *number > longestPreRollS)
            return call.wrongCall(
                ODO_TEXT("app.pre_roll_is", "--pre-roll is a number of seconds from 0 to 30"));
        settings.preRollS = *number;
    }
    return settings;
}

double rateOf(const ViewRecording &view)
{
    const double lengthS = view.taken.empty() ? 0 : toSeconds(view.taken.back() - view.taken.front());
    return lengthS > 0 ? double(view.taken.size() - 1) / lengthS : 0;
}

/// When it was started, since its first frame.
double startOf(const TrialRecord &trial)
{
    const auto start = trial.variables.find(startVariable);
    return start == trial.variables.end() ? 0 : QString::fromStdString(start->second).toDouble();
}

/// "A: 300 frames, 30.0 a second, none lost", on a line of its own.
QString viewWords(const QString &name, const ViewRecording &view)
{
    const std::uint64_t lost = view.lostOnWire + view.lostByUs;
    return QStringLiteral("\nView %1: %2, %3 a second, %4 lost.")
        .arg(name)
        .arg(counted(view.taken.size(), QStringLiteral("frame")))
        .arg(rateOf(view), 0, 'f', 1)
        .arg(lost == 0 ? QStringLiteral("none") : QString::number(lost));
}

QJsonObject viewsJson(const LiveTrial &recorded, const RecordSettings &settings)
{
    QJsonObject views;
    for (std::size_t i = 0; i < settings.cameras.size(); ++i) {
        const ViewRecording &view = recorded.outcome().views[i];
        views.insert(QString::fromStdString(settings.cameras[i].first),
                     QJsonObject{{QStringLiteral("frames"), qint64(view.frames)},
                                 {QStringLiteral("recorded"), qint64(view.taken.size())},
                                 {QStringLiteral("lost_on_wire"), qint64(view.lostOnWire)},
                                 {QStringLiteral("lost_by_us"), qint64(view.lostByUs)},
                                 {QStringLiteral("fps"), rateOf(view)},
                                 {QStringLiteral("latency_p99_ms"), 1000 * percentile(view.latenciesS, 99)}});
    }
    return views;
}

/// The parser knows no value that can be left out: `--ssl-vision` alone gets an empty one. What follows it is
/// its value, unless that is an option or the project.
QStringList withTarget(QStringList arguments)
{
    const QString option = QStringLiteral("--") + option::sslVision;
    for (qsizetype i = arguments.indexOf(option); i >= 0; i = arguments.indexOf(option, i + 1)) {
        const QString next = arguments.value(i + 1, QStringLiteral("-"));
        const bool isValue =
            !next.startsWith(u'-') && !next.endsWith(QStringLiteral(".odo"), Qt::CaseInsensitive);
        arguments[i] += u'=' + (isValue ? next : QString());
        if (isValue)
            arguments.removeAt(i + 1);
    }
    return arguments;
}

} // namespace

Result<void> runRecord(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("record"),
         QStringLiteral("P.odo --trial NAME --camera A=URI [--camera B=URI]... [--seconds 10] [--pre-roll 0] "
                        "[--robot R]... [--ssl-vision [ADDRESS:PORT]] [--json] | P.odo --recover"),
         1,
         1,
         {{option::trial, QStringLiteral("What the trial is called."), QStringLiteral("NAME")},
          {option::camera, QStringLiteral("A view: the camera's name and its address; see odograph cameras."),
           QStringLiteral("CAMERA=URI")},
          {option::seconds, QStringLiteral("How long to record, from when all cameras deliver frames."),
           QStringLiteral("SECONDS")},
          {option::preRoll,
           QStringLiteral(
               "How long to record before that, at most 30 seconds; the cameras run for this time first."),
           QStringLiteral("SECONDS")},
          {option::robot, QStringLiteral("A robot in view."), QStringLiteral("R")},
          {option::sslVision,
           QStringLiteral("Sends the robots' live positions as SSL-Vision packets, on this computer's "
                          "loopback only; default address: 224.5.23.2:10006."),
           QStringLiteral("[ADDRESS:PORT]")},
          {option::recover,
           QStringLiteral(
               "Records nothing: completes recordings that were cut off, as every writing command does.")}}},
        cancel);
    if (const auto parsed = call.parse(withTarget(arguments)); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (call.isSet(option::recover))
        return answerRecover(call);
    auto settings = ODO_TRY(recordSettings(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    settings.warn = CommandCall::warn;
    const auto awake = SleepInhibitor::take("recording");
    const auto job = ODO_TRY(recordTrial(*project, settings, call.control()));
    const LiveTrial &recorded = *job;
    const PairStatistics &pairs = recorded.outcome().pairs;
    std::vector<double> errorsS;
    for (const double errorS : pairs.errorsS)
        errorsS.push_back(std::abs(errorS));
    const double medianMs = 1000 * percentile(errorsS, 50);
    QString words = QStringLiteral("Trial %1 recorded: %2 s.")
                        .arg(QString::fromStdString(recorded.trial().name))
                        .arg(recorded.trial().durationS, 0, 'f', 2);
    for (std::size_t i = 0; i < settings.cameras.size(); ++i)
        words += viewWords(QString::fromStdString(settings.cameras[i].first), recorded.outcome().views[i]);
    if (!errorsS.empty())
        words += QStringLiteral("\nThe views are %1, which the analysis takes into account.")
                     .arg(english(synchronisationWords(percentile(errorsS, 95))));
    call.answer({{QStringLiteral("trial"), QString::fromStdString(recorded.trial().name)},
                 {QStringLiteral("duration_s"), recorded.trial().durationS},
                 {QStringLiteral("start_s"), startOf(recorded.trial())},
                 {QStringLiteral("views"), viewsJson(recorded, settings)},
                 {QStringLiteral("pairs"), qint64(pairs.pairs)},
                 {QStringLiteral("unpaired"), qint64(pairs.unpaired)},
                 {QStringLiteral("pair_error_ms"),
                  QJsonObject{{QStringLiteral("median"), medianMs},
                              {QStringLiteral("p95"), 1000 * percentile(errorsS, 95)},
                              {QStringLiteral("max"), 1000 * percentile(errorsS, 100)}}}},
                words);
    for (const Message &warning : recorded.warnings())
        CommandCall::warn(warning);
    if (!call.control().isCancelled())
        return {};
    return fail(ErrorCode::Cancelled, recordingSubject(recorded.trial().name),
                ODO_TEXT("app.stopped_early", "it was stopped early"),
                ODO_TEXT("app.recorded_kept", "what was recorded until then is kept"));
}

} // namespace odo
