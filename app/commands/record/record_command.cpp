// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/base/error.h"
#include "core/base/percentile.h"
#include "core/base/platform/sleep_inhibitor.h"
#include "core/project/names.h"
#include "core/project/repositories.h"
#include "core/workflow/record/record_trial.h"
#include "core/workflow/shared_words.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

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

constexpr double longestRestS = 3600;

/// "zone:NAME" and "leave:NAME".
std::optional<RunTrigger> zoneTrigger(const QString &word)
{
    const QString name = word.section(u':', 1);
    if (name.isEmpty())
        return std::nullopt;
    if (word.startsWith(QStringLiteral("zone:")))
        return RunTrigger{RunTrigger::Kind::Entry, name.toStdString()};
    if (word.startsWith(QStringLiteral("leave:")))
        return RunTrigger{RunTrigger::Kind::Exit, name.toStdString()};
    return std::nullopt;
}

Result<std::optional<RunTrigger>> startOn(const CommandCall &call)
{
    if (!call.isSet(option::startOn))
        return std::nullopt;
    const QString word = QString::fromStdString(call.value(option::startOn));
    if (word == QStringLiteral("motion"))
        return RunTrigger{RunTrigger::Kind::Motion};
    if (word == QStringLiteral("gate"))
        return RunTrigger{RunTrigger::Kind::Gate};
    if (const auto zone = zoneTrigger(word))
        return *zone;
    return call.wrongCall(
        ODO_TEXT("app.start_on_is", "--start-on is motion, gate, zone:NAME (entered) or leave:NAME"));
}

Result<std::optional<RunTrigger>> stopOn(const CommandCall &call)
{
    if (!call.isSet(option::stopOn))
        return std::nullopt;
    const QString word = QString::fromStdString(call.value(option::stopOn));
    if (word == QStringLiteral("finish"))
        return RunTrigger{RunTrigger::Kind::Gate};
    if (word == QStringLiteral("motion"))
        return RunTrigger{RunTrigger::Kind::Motion, {}, usualRest};
    const bool isRest = word.startsWith(QStringLiteral("motion:"));
    if (const auto number = parseNumber((isRest ? word.section(u':', 1) : word).toStdString());
        number && *number > 0 && *number <= (isRest ? longestRestS : longestRecordingS))
        return RunTrigger{
            isRest ? RunTrigger::Kind::Motion : RunTrigger::Kind::Time, {}, fromSeconds(*number)};
    if (const auto zone = zoneTrigger(word))
        return *zone;
    return call.wrongCall(
        ODO_TEXT("app.stop_on_is",
                 "--stop-on is motion, motion:SECONDS, finish, zone:NAME (entered), leave:NAME or SECONDS"));
}

/// --start-on and --stop-on, with the task and the seconds that go with them.
Result<void> readTriggers(const CommandCall &call, RecordSettings &settings)
{
    settings.task = call.value(option::task);
    settings.start = ODO_TRY(startOn(call));
    settings.stop = ODO_TRY(stopOn(call));
    if (!settings.stop)
        return {};
    const bool isTime = settings.stop->kind == RunTrigger::Kind::Time;
    if (isTime && call.isSet(option::seconds))
        return call.wrongCall(
            ODO_TEXT("app.seconds_twice", "--seconds and --stop-on SECONDS mean the same; give one of them"));
    if (isTime)
        settings.seconds = toSeconds(settings.stop->time);
    else if (!call.isSet(option::seconds))
        settings.seconds = toSeconds(RunSettings().longest);
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
    ODO_TRY(readTriggers(call, settings));
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
                        "[--task TASK] [--start-on motion|gate|zone:NAME|leave:NAME] [--stop-on "
                        "motion|finish|zone:NAME|leave:NAME|SECONDS] [--robot R]... [--ssl-vision "
                        "[ADDRESS:PORT]] [--json] | P.odo --recover"),
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
          {option::task, QStringLiteral("The task whose gates and zones start and end the recording."),
           QStringLiteral("TASK")},
          {option::startOn,
           QStringLiteral("Waits, and starts when something moves on the floor (motion), or a robot passes "
                          "the start (gate), enters a zone or leaves it. The second before is recorded too."),
           QStringLiteral("motion|gate|zone:NAME|leave:NAME")},
          {option::stopOn,
           QStringLiteral("Ends when nothing has moved for 1.5 seconds (motion, or motion:SECONDS), every "
                          "robot has finished, one enters a zone or leaves it, or so long after the start."),
           QStringLiteral("motion|finish|zone:NAME|leave:NAME|SECONDS")},
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
