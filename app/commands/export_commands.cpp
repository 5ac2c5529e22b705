// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/command_output.h"
#include "app/commands/commands.h"
#include "app/commands/export_page.h"
#include "app/workbench.h"
#include "core/base/file_system.h"
#include "core/exchange/track_export.h"
#include "core/exchange/trial_json.h"
#include "core/files/file_words.h"
#include "core/files/output_file.h"
#include "core/project/repositories.h"
#include "core/workflow/export_job.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/trial_verdict.h"
#include "core/workflow/trial_sources.h"
#include "ui/report/annotated_video.h"

#include <QJsonArray>
#include <algorithm>
#include <optional>
#include <set>
#include <span>

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
    const auto trial = ODO_TRY(project->trials().find(call.text(1)));
    AnnotatedVideoJob job(call.text(1), settings);
    ODO_TRY(runToEnd(job, *project, call.control()));
    return output.finish(
        call,
        {{QStringLiteral("file"), file},
         {QStringLiteral("format"), QStringLiteral("video")},
         {QStringLiteral("range"), rangeJson(trial)},
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

/// How tracks are written.
struct ExportFormat
{
    std::string name; ///< csv, tum, json or tracker
    CsvStyle style = CsvStyle::Analysis;
    std::vector<std::size_t> columns;        ///< of CSV; empty: all
    CsvLength unit = CsvLength::Millimetres; ///< of CSV
    TrackFrame frame = TrackFrame::Floor;    ///< not of JSON

    const char *ending() const
    {
        return name == "csv" ? ".csv" : name == "json" ? ".json" : name == "tum" ? ".tum" : ".txt";
    }
    FileKind kind() const
    {
        return name == "csv"    ? FileKind::Csv
               : name == "json" ? FileKind::Json
               : name == "tum"  ? FileKind::Tum
                                : FileKind::Tracker;
    }
};

Result<ExportFormat> exportFormat(const CommandCall &call, const std::string &name)
{
    ExportFormat format{name, ODO_TRY(csvStyleOf(call)), {}};
    const auto unit = csvLengthFromWord(call.value(option::unit));
    if (!unit)
        return call.wrongCall(ODO_TEXT("app.unit_is", "--unit is mm, cm, m or in"));
    if (call.isSet(option::unit) && name != "csv")
        return call.wrongCall(ODO_TEXT("app.unit_is_of_csv", "--unit goes with --format csv"));
    const auto frame = trackFrameFromWord(call.value(option::axes));
    if (!frame)
        return call.wrongCall(ODO_TEXT("app.axes_are", "--axes is floor or start"));
    if (*frame != TrackFrame::Floor && name == "json")
        return call.wrongCall(ODO_TEXT("app.json_has_floor_axes", "a JSON file has the axes of the floor"));
    format.unit = *unit;
    format.frame = *frame;
    if (!call.isSet(option::columns))
        return format;
    if (name != "csv")
        return call.wrongCall(ODO_TEXT("app.columns_are_of_csv", "--columns goes with --format csv"));
    std::vector<std::string> columns;
    for (const QString &value : call.values(option::columns))
        for (const QString &column : value.split(u','))
            columns.push_back(column.trimmed().toStdString());
    auto chosen = parseCsvColumns(columns);
    if (!chosen)
        return call.wrongCall(joined({chosen.error().what, chosen.error().why}, Join::Colon));
    format.columns = std::move(*chosen);
    return format;
}

/// A trial with all that its files have.
struct ExportedTrial
{
    TrialRecord trial;
    std::vector<RecordingRecord> recordings;
    std::vector<AnalysisRecord> analyses;
    std::vector<ImportedTrack> imported;
    TrialVerdict verdict;
};

Result<ExportedTrial> readExported(Project &project, const TrialRecord &trial)
{
    ExportedTrial exported{trial,
                           ODO_TRY(project.trials().recordings(trial.id)),
                           ODO_TRY(project.analyses().current(trial.id)),
                           ODO_TRY(importedTracksOf(project, trial)),
                           {}};
    std::vector<const RecordingRecord *> views;
    for (const RecordingRecord &recording : exported.recordings)
        views.push_back(&recording);
    exported.verdict = ODO_TRY(verdictOn(project, trial, views, exported.analyses));
    return exported;
}

/// robot: empty: of JSON all of them, else the trial's only one. The choice is checked before anything is
/// written.
Result<void> writeExported(const CommandCall &call, const ExportedTrial &from, const std::string &robot,
                           const ExportFormat &format, const OutputTarget &target)
{
    const bool holdsAll = format.name == "json" && robot.empty() && !from.analyses.empty();
    const auto chosen = chosenRobot(from.analyses, from.trial.name, robot);
    if (!holdsAll && !chosen)
        return tl::unexpected(chosen.error());
    return writeOutput(target, [&](const TextSink &given) {
        const TextSink sink = [&](std::string_view piece) {
            return call.control().isCancelled() ? Result<void>(cancelled(exportSubject(from.trial.name)))
                                                : given(piece);
        };
        if (format.name == "json")
            return writeTrialJson(from.trial, from.recordings,
                                  holdsAll ? std::span(from.analyses) : std::span(*chosen, 1), from.imported,
                                  from.verdict, sink);
        TrackExport how;
        how.format = format.name == "tum"       ? ExportedFormat::Tum
                     : format.name == "tracker" ? ExportedFormat::Tracker
                                                : ExportedFormat::Csv;
        how.style = format.style;
        how.columns = format.columns;
        how.unit = format.unit;
        how.frame = format.frame;
        return writeTrack(exportedPart(**chosen, how), how, sink);
    });
}

Result<void> exportFile(const CommandCall &call, const ExportFormat &format, const QString &file)
{
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    // the text shows its kind
    const auto output = ODO_TRY(CommandOutput::of(call, file, std::nullopt, project.get()));
    const auto trial = ODO_TRY(project->trials().find(call.text(1)));
    const auto exported = ODO_TRY(readExported(*project, trial));
    ODO_TRY(writeExported(call, exported, call.value(option::robot), format, output.target()));
    return output.finish(call,
                         {{QStringLiteral("file"), file},
                          {QStringLiteral("format"), QString::fromStdString(format.name)},
                          {QStringLiteral("range"), rangeJson(trial)}},
                         QStringLiteral("Wrote %1.").arg(file) +
                             (trial.range ? u'\n' + english(rangeSentence(trial)) : QString()));
}

/// A file of an export to a folder.
struct PlannedFile
{
    TrialRecord trial;
    std::string robot; ///< empty: all of the trial, in a JSON
    OutputTarget target;
};

/// One file for each robot of each trial, of JSON for each trial, whose names differ from one another.
Result<std::vector<PlannedFile>> plannedFiles(const CommandCall &call, Project &project,
                                              const ExportFormat &format, const std::filesystem::path &folder)
{
    std::vector<PlannedFile> files;
    std::set<RecordId> seen;
    std::set<std::string> names;
    for (const QString &name : call.positionals().mid(1)) {
        const auto trial = ODO_TRY(project.trials().find(name.toStdString()));
        if (!seen.insert(trial.id).second)
            continue;
        const auto analyses = ODO_TRY(project.analyses().currentMetrics(trial.id));
        std::vector<std::string> robots;
        for (const AnalysisRecord &analysis : analyses)
            robots.push_back(analysis.robotName);
        if (call.isSet(option::robot) || analyses.empty())
            robots = {ODO_TRY(chosenRobot(analyses, trial.name, call.value(option::robot)))->robotName};
        else if (format.name == "json")
            robots = {std::string()};
        for (const std::string &robot : robots) {
            const std::string stem = exportName(trial.name, robot, !robot.empty() && analyses.size() > 1);
            std::string free = stem;
            for (int number = 2; !names.insert(free).second; ++number)
                free = stem + ' ' + std::to_string(number);
            files.push_back({trial,
                             robot,
                             {folder / (free + format.ending()),
                              call.isSet(option::force) ? Existing::ReplaceAny : Existing::ReplaceSameKind}});
        }
    }
    return files;
}

/// Makes it where it is missing.
Result<void> ensureFolder(const CommandCall &call, const std::filesystem::path &folder)
{
    if (files::isFolder(folder))
        return {};
    if (files::exists(folder))
        return fail(ErrorCode::WrongCall, folderCalled(folder),
                    ODO_TEXT("app.is_no_folder", "it is not a folder"),
                    ODO_TEXT("app.several_trials_need_folder", "several trials are exported to a folder"));
    ODO_TRY(checkOutput({folder, Existing::Refuse}, std::nullopt));
    std::error_code problem;
    if (!call.control().isCancelled() && !files::makeFolders(folder, problem))
        return fail(ErrorCode::Io, folderCalled(folder), cannotBeWritten(problem.message()),
                    ODO_TEXT("app.check_folder_rights", "check the rights of the folder around it"));
    return {};
}

Result<void> exportToFolder(const CommandCall &call, const ExportFormat &format, const QString &name)
{
    std::filesystem::path folder = name.toStdString();
    if (!folder.has_filename())
        folder = folder.parent_path();
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const auto files = ODO_TRY(plannedFiles(call, *project, format, folder));
    ODO_TRY(ensureFolder(call, folder));
    ODO_TRY(protectRecordings(call, *project));
    for (const PlannedFile &file : files)
        ODO_TRY(checkOutput(file.target, format.kind()));
    QJsonArray written;
    std::optional<ExportedTrial> exported;
    for (const PlannedFile &file : files) {
        if (!exported || exported->trial.id != file.trial.id)
            exported = ODO_TRY(readExported(*project, file.trial));
        ODO_TRY(writeExported(call, *exported, file.robot, format, file.target));
        written.append(QString::fromStdString(file.target.file.string()));
    }
    call.answer({{QStringLiteral("folder"), name},
                 {QStringLiteral("files"), written},
                 {QStringLiteral("format"), QString::fromStdString(format.name)}},
                QStringLiteral("Wrote %1 to %2.").arg(counted(written.size(), QStringLiteral("file")), name));
    return {};
}

} // namespace

Result<void> runExport(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("export"),
         QStringLiteral("P.odo TRIAL... -o FILE|FOLDER|- [--force] [--robot R] "
                        "[--format csv|tum|json|tracker|html|video] "
                        "[--csv-style analysis|international|continental] [--columns COLUMN[,...]] "
                        "[--unit mm|cm|m|in] [--axes floor|start] "
                        "[--speed 0.25] [--size 1920x1080] [--theme light|dark]"),
         2, -1,
         outputOptions(QStringLiteral(
             "The file to write; of several trials, or with / behind its name, the folder to write to. A "
             "page (html) holds all trials.")) +
             QList<QCommandLineOption>{
                 {option::robot, QStringLiteral("The robot, if the trial has several."), QStringLiteral("R")},
                 {option::format, QStringLiteral("Of the file."), QStringLiteral("FORMAT"),
                  QStringLiteral("csv")},
                 csvStyleOption(),
                 {option::columns,
                  QStringLiteral(
                      "These columns of the CSV in this order, separated by commas; default: all."),
                  QStringLiteral("COLUMN[,...]")},
                 {option::unit, QStringLiteral("Of all lengths of the CSV."), QStringLiteral("UNIT"),
                  QStringLiteral("mm")},
                 {option::axes,
                  QStringLiteral("Of the floor's markers, or from the start of the run in its direction."),
                  QStringLiteral("AXES"), QStringLiteral("floor")}} +
             videoOptions()},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output))
        return call.missing(option::output);
    static const std::vector<std::string> formats = {"csv", "tum", "json", "tracker", "html", "video"};
    const std::string formatName = call.value(option::format);
    if (std::find(formats.begin(), formats.end(), formatName) == formats.end())
        return call.wrongCall(
            ODO_TEXT("app.format_is", "--format is csv, tum, json, tracker, html or video"));
    const QString file = QString::fromStdString(call.value(option::output));
    if (formatName == "html")
        return exportPage(call, file);
    const bool areSeveral = call.positionals().size() > 2;
    if (areSeveral && (file == standardOutput || formatName == "video"))
        return call.wrongCall(ODO_TEXT("app.one_trial_only",
                                       "standard output and videos take one trial; several tracks go to a "
                                       "folder"));
    if (formatName == "video" && file == standardOutput)
        return call.wrongCall(ODO_TEXT("app.video_needs_file", "a video needs a file, not standard output"));
    const auto format = ODO_TRY(exportFormat(call, formatName));
    if (formatName == "video")
        return exportVideo(call, file);
    return areSeveral || file.endsWith(u'/') ? exportToFolder(call, format, file)
                                             : exportFile(call, format, file);
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
