// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/command_output.h"
#include "app/commands/commands.h"
#include "app/workbench.h"
#include "core/exchange/track_export.h"
#include "core/exchange/trial_json.h"
#include "core/files/file_words.h"
#include "core/files/output_file.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/trial_verdict.h"
#include "core/workflow/trial_sources.h"
#include "ui/report/annotated_video.h"

#include <algorithm>

namespace odo {

namespace {

Result<AnnotatedVideoSettings> settingsOf(const CommandCall &call)
{
    AnnotatedVideoSettings settings;
    const auto wantedSize = ODO_TRY(call.sizePair(option::size));
    settings.sizePx = QSize(static_cast<int>(wantedSize.first), static_cast<int>(wantedSize.second));
    if (!AnnotatedVideoSettings::isSize(settings.sizePx))
        return call.wrongCall(
            ODO_TEXT("app.video_size_is", "--size has even numbers, from 320x180 to 3840x2160"));
    const auto wantedSpeed = ODO_TRY(call.number(option::speed));
    if (!AnnotatedVideoSettings::isSpeed(wantedSpeed))
        return call.wrongCall(ODO_TEXT("app.speed_is", "--speed is from 0.1 to 1"));
    settings.speed = wantedSpeed;
    const std::string themeName = call.value(option::theme);
    if (themeName != "light" && themeName != "dark")
        return call.wrongCall(ODO_TEXT("app.theme_is", "--theme is light or dark"));
    settings.isDark = themeName == "dark";
    return settings;
}

} // namespace

/// The options of `export --format video`, for its syntax.
QList<QCommandLineOption> videoOptions()
{
    return {{option::speed, QStringLiteral("Speed of a video, relative to the run: 0.1 to 1."),
             QStringLiteral("S"), QStringLiteral("1")},
            {option::size, QStringLiteral("Size of a video, in pixels."), QStringLiteral("WxH"),
             QStringLiteral("1920x1080")},
            {option::theme, QStringLiteral("Theme of a video: light or dark."), QStringLiteral("THEME"),
             QStringLiteral("light")},
            languageOption()};
}

/// Makes the annotated video of a trial and answers. Needs a QGuiApplication.
Result<void> exportVideo(const CommandCall &call, const QString &file)
{
    auto settings = ODO_TRY(settingsOf(call));
    ODO_TRY(applyLanguage(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    // the job knows its kind
    const auto output = ODO_TRY(CommandOutput::of(call, file, std::nullopt, project.get()));
    settings.target = output.target();
    AnnotatedVideoJob job(call.text(1), settings);
    ODO_TRY(runToEnd(job, *project, call.control()));
    return output.finish(
        call,
        {{QStringLiteral("file"), file},
         {QStringLiteral("format"), QStringLiteral("video")},
         {QStringLiteral("frames"), job.frameCount()},
         {QStringLiteral("duration_s"), job.durationS()}},
        QStringLiteral("Wrote %1: %2 s.").arg(file, QString::number(job.durationS(), 'f', 1)));
}

namespace {

Message exportSubject(const std::string &trial)
{
    return ODO_TEXT("app.export_of_trial", "export of trial '%1'")(Named::trial(trial));
}

/// The one robot whose track the file is to hold.
Result<const AnalysisRecord *> chosenRobot(const std::vector<AnalysisRecord> &analyses,
                                           const std::string &trial, const std::string &name)
{
    std::vector<std::string> names;
    for (const AnalysisRecord &analysis : analyses) {
        if (analysis.robotName == name || (name.empty() && analyses.size() == 1))
            return &analysis;
        names.push_back(analysis.robotName);
    }
    const Message what = exportSubject(trial);
    if (analyses.empty())
        return fail(ErrorCode::NotFound, what, notTrackedYet(),
                    ODO_TEXT("app.run_track_first", "run odograph track first"));
    if (name.empty())
        return fail(ErrorCode::Undetermined, what, severalRobots(names),
                    ODO_TEXT("app.choose_robot", "choose one with --robot"));
    return fail(ErrorCode::NotFound, what, robotNotTracked(name, names),
                ODO_TEXT("app.track_or_choose_robot", "track it, or choose another with --robot"));
}

/// Writes the file's text to a sink; made first, for the choice of robot and style may be wrong.
using WriteText = std::function<Result<void>(const TextSink &)>;

Result<WriteText> fileText(const CommandCall &call, const std::string &formatName, const TrialRecord &trial,
                           const std::vector<RecordingRecord> &recordings,
                           const std::vector<AnalysisRecord> &analyses,
                           const std::vector<ImportedTrack> &imported, const TrialVerdict &verdict)
{
    const auto chosen = chosenRobot(analyses, trial.name, call.value(option::robot));
    if (formatName == "json" && !call.isSet(option::robot) && !analyses.empty())
        return [&](const TextSink &sink) {
            return writeTrialJson(trial, recordings, analyses, imported, verdict, sink);
        };
    if (!chosen)
        return tl::unexpected(chosen.error());
    const AnalysisRecord &analysis = **chosen;
    if (formatName == "json")
        return [&](const TextSink &sink) {
            return writeTrialJson(trial, recordings, {&analysis, 1}, imported, verdict, sink);
        };
    if (formatName == "tum")
        return [&](const TextSink &sink) { return writeTrackTum(analysis, sink); };
    if (formatName == "tracker")
        return [&](const TextSink &sink) { return writeTrackTracker(analysis, sink); };
    const auto style = parseCsvStyle(call.value(option::csvStyle));
    if (!style)
        return call.wrongCall(
            ODO_TEXT("app.csv_style_is", "--csv-style is analysis, international or continental"));
    return [&analysis, style = *style](const TextSink &sink) { return writeTrackCsv(analysis, style, sink); };
}

} // namespace

Result<void> runExport(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("export"),
         QStringLiteral("P.odo TRIAL -o FILE [--force] [--robot R] [--format csv|tum|json|tracker|video] "
                        "[--csv-style analysis|international|continental] "
                        "[--speed 0.25] [--size 1920x1080] [--theme light|dark]"),
         2, 2,
         outputOptions(QStringLiteral("The file to write.")) +
             QList<QCommandLineOption>{
                 {option::robot, QStringLiteral("The robot, if the trial has several."), QStringLiteral("R")},
                 {option::format, QStringLiteral("Of the file."), QStringLiteral("FORMAT"),
                  QStringLiteral("csv")},
                 {option::csvStyle, QStringLiteral("CSV style, by the program that reads it."),
                  QStringLiteral("STYLE"), QStringLiteral("analysis")}} +
             videoOptions()},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output))
        return call.missing(option::output);
    static const std::vector<std::string> formats = {"csv", "tum", "json", "tracker", "video"};
    const std::string formatName = call.value(option::format);
    if (std::find(formats.begin(), formats.end(), formatName) == formats.end())
        return call.wrongCall(ODO_TEXT("app.format_is", "--format is csv, tum, json, tracker or video"));
    const QString file = QString::fromStdString(call.value(option::output));
    if (formatName == "video" && file == standardOutput)
        return call.wrongCall(ODO_TEXT("app.video_needs_file", "a video needs a file, not standard output"));
    if (formatName == "video")
        return exportVideo(call, file);
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    // the text shows its kind
    const auto output = ODO_TRY(CommandOutput::of(call, file, std::nullopt, project.get()));
    const auto trial = ODO_TRY(project->trials().find(call.text(1)));
    const auto recordings = ODO_TRY(project->trials().recordings(trial.id));
    const auto analyses = ODO_TRY(project->analyses().current(trial.id));
    const auto imported = ODO_TRY(importedTracksOf(*project, trial));
    std::vector<const RecordingRecord *> views;
    for (const RecordingRecord &recording : recordings)
        views.push_back(&recording);
    const auto verdict = ODO_TRY(verdictOn(*project, trial, views, analyses));
    const auto text = ODO_TRY(fileText(call, formatName, trial, recordings, analyses, imported, verdict));
    const WriteText untilCancelled = [&](const TextSink &sink) {
        return text([&](std::string_view piece) {
            return cancel.isCancelled() ? Result<void>(cancelled(exportSubject(trial.name))) : sink(piece);
        });
    };
    ODO_TRY(writeOutput(output.target(), untilCancelled));
    return output.finish(
        call,
        {{QStringLiteral("file"), file}, {QStringLiteral("format"), QString::fromStdString(formatName)}},
        QStringLiteral("Wrote %1.").arg(file));
}

namespace {

constexpr double smallestPx = 200, largestPx = 4000;

Result<CommandOutput> snapshotOutput(const CommandCall &call)
{
    const auto project = call.openProject(0, Project::Access::ReadOnly); // closed again: the window opens it
    if (!project)
        return tl::unexpected(project.error());
    return CommandOutput::of(call, QString::fromStdString(call.value(option::output)), std::nullopt,
                             project->get(), QStringLiteral(".png"));
}

} // namespace

Result<void> runSnapshot(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("snapshot"),
         QStringLiteral("P.odo TRIAL -o image.png [--force] [--mode review|compare|history|testbed] [--size "
                        "1600x1000] [--language en]"),
         2, 2,
         outputOptions(QStringLiteral("The image file to write.")) +
             QList<QCommandLineOption>{{option::mode, QStringLiteral("What the window shows."),
                                        QStringLiteral("MODE"), QStringLiteral("review")},
                                       {option::size, QStringLiteral("Size of the window, in pixels."),
                                        QStringLiteral("WxH"), QStringLiteral("1600x1000")},
                                       languageOption()}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output))
        return call.missing(option::output);
    const auto wanted = ODO_TRY(call.sizePair(option::size));
    const auto inRange = [](double px) { return px >= smallestPx && px <= largestPx; };
    if (!inRange(wanted.first) || !inRange(wanted.second))
        return call.wrongCall(ODO_TEXT("app.window_size_is", "--size is from 200x200 to 4000x4000"));
    const auto shown = modeFromWord(QString::fromStdString(call.value(option::mode)));
    if (!shown || *shown == WindowMode::Record) // which shows no trial
        return call.wrongCall(ODO_TEXT("app.mode_is", "--mode is review, compare, history or testbed"));
    ODO_TRY(applyLanguage(call));
    const auto output = ODO_TRY(snapshotOutput(call));
    ODO_TRY(paintWorkbench(call.text(0), call.text(1), *shown, QSize(int(wanted.first), int(wanted.second)),
                           output.target(), cancel));
    const QString file = QString::fromStdString(call.value(option::output));
    return output.finish(call, {{QStringLiteral("image"), file}}, QStringLiteral("Wrote %1.").arg(file));
}

} // namespace odo
