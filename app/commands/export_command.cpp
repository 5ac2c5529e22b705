// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/commands/export_video.h"
#include "app/option_names.h"
#include "app/output_option.h"
#include "core/files/output_file.h"
#include "core/exchange/track_csv.h"
#include "core/exchange/track_text.h"
#include "core/exchange/trial_json.h"
#include "core/project/repositories.h"
#include "core/workflow/imported_tracks.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace odo {

namespace {

/// The one robot whose track the file is to hold.
Result<const AnalysisRecord *> chosenRobot(const std::vector<AnalysisRecord> &analyses, const std::string &trial,
                                   const std::string &name)
{
    std::string names;
    for (const AnalysisRecord &analysis : analyses) {
        if (analysis.robotName == name || (name.empty() && analyses.size() == 1))
            return &analysis;
        names += (names.empty() ? "'" : ", '") + analysis.robotName + "'";
    }
    const std::string what = "export of trial '" + trial + "'";
    if (analyses.empty())
        return fail(ErrorCode::NotFound, what, "it has not been tracked yet", "run odograph track first");
    if (name.empty())
        return fail(ErrorCode::Undetermined, what, "it has several robots: " + names, "choose one with --robot");
    return fail(ErrorCode::NotFound, what, "robot '" + name + "' was not tracked in it, but " + names,
                "track it, or choose another with --robot");
}

/// Writes the file's text to a sink; made first, for the choice of robot and style may be wrong.
using WriteText = std::function<Result<void>(const TextSink &)>;

Result<WriteText> fileText(const CommandCall &call, const std::string &formatName, const TrialRecord &trial,
                           const std::vector<RecordingRecord> &recordings, const std::vector<AnalysisRecord> &analyses,
                           const std::vector<ImportedTrack> &imported)
{
    const auto chosen = chosenRobot(analyses, trial.name, call.value(option::robot));
    if (formatName == "json" && !call.isSet(option::robot) && !analyses.empty())
        return [&](const TextSink &sink) { return writeTrialJson(trial, recordings, analyses, imported, sink); };
    if (!chosen)
        return tl::unexpected(chosen.error());
    const AnalysisRecord &analysis = **chosen;
    if (formatName == "json")
        return [&](const TextSink &sink) { return writeTrialJson(trial, recordings, {&analysis, 1}, imported, sink); };
    if (formatName == "tum")
        return [&](const TextSink &sink) { return writeTrackTum(analysis, sink); };
    if (formatName == "tracker")
        return [&](const TextSink &sink) { return writeTrackTracker(analysis, sink); };
    const auto style = parseCsvStyle(call.value(option::csvStyle));
    if (!style)
        return call.wrongCall(QStringLiteral("--csv-style is analysis, international or continental"));
    return [&analysis, style = *style](const TextSink &sink) { return writeTrackCsv(analysis, style, sink); };
}

constexpr const char *standardOutput = "-"; // in place of a file

Result<void> print(std::string_view piece)
{
    if (std::fwrite(piece.data(), 1, piece.size(), stdout) == piece.size())
        return {};
    return fail(ErrorCode::Io, "standard output", std::string("it cannot be written (") + std::strerror(errno) + ")", "give it to a program or a file that takes all of it");
}

} // namespace

Result<void> runExport(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("export"),
                      QStringLiteral("P.odo TRIAL -o FILE [--force] [--robot R] [--format csv|tum|json|tracker|video] "
                                     "[--csv-style analysis|international|continental] "
                                     "[--speed 0.25] [--size 1920x1080] [--theme light|dark]"),
                      2, 2,
                      outputOptions(QStringLiteral("The file to write; - is standard output.")) + QList<QCommandLineOption>{
                       {option::robot, QStringLiteral("The robot, where there are several."), QStringLiteral("R")},
                       {option::format, QStringLiteral("Of the file."), QStringLiteral("FORMAT"), QStringLiteral("csv")},
                       {option::csvStyle, QStringLiteral("For which program."), QStringLiteral("STYLE"), QStringLiteral("analysis")}} +
                          videoOptions()},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output))
        return call.wrongCall(QStringLiteral("-o is missing"));
    static const std::vector<std::string> formats = {"csv", "tum", "json", "tracker", "video"};
    const std::string formatName = call.value(option::format);
    if (std::find(formats.begin(), formats.end(), formatName) == formats.end())
        return call.wrongCall(QStringLiteral("--format is csv, tum, json, tracker or video"));
    const bool isPrinted = call.value(option::output) == standardOutput;
    if (isPrinted && formatName == "video")
        return call.wrongCall(QStringLiteral("a video needs a file, not standard output"));
    if (isPrinted && call.json())
        return call.wrongCall(QStringLiteral("-o - and --json would both write to standard output"));
    if (formatName == "video")
        return exportVideo(call, call.value(option::output));
    const auto project = call.openProject(0, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    const auto target = isPrinted ? Result<OutputTarget>() : outputOf(call, call.value(option::output), std::nullopt, project->get()); // the text tells its kind
    if (!target)
        return tl::unexpected(target.error());
    const auto trial = (*project)->trials().find(call.text(1));
    if (!trial)
        return tl::unexpected(trial.error());
    const auto recordings = (*project)->trials().recordings(trial->id);
    if (!recordings)
        return tl::unexpected(recordings.error());
    const auto analyses = (*project)->analyses().current(trial->id);
    if (!analyses)
        return tl::unexpected(analyses.error());
    const auto imported = importedTracksOf(**project, *trial);
    if (!imported)
        return tl::unexpected(imported.error());
    const auto text = fileText(call, formatName, *trial, *recordings, *analyses, *imported);
    if (!text)
        return tl::unexpected(text.error());
    const WriteText untilCancelled = [&](const TextSink &sink) {
        return (*text)([&](std::string_view piece) { return cancel.isCancelled() ? Result<void>(cancelled("export of trial '" + trial->name + "'")) : sink(piece); });
    };
    if (isPrinted)
        return untilCancelled(print);
    if (auto written = writeOutput(*target, untilCancelled); !written)
        return written;
    const QString file = QString::fromStdString(call.value(option::output));
    call.answer({{QStringLiteral("file"), file}, {QStringLiteral("format"), QString::fromStdString(formatName)}},
                QStringLiteral("Wrote %1.").arg(file));
    return {};
}

} // namespace odo
