// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/trial_commands.h"

#include "app/answers.h"
#include "app/command_call.h"
#include "app/command_output.h"
#include "core/base/error.h"
#include "core/project/names.h"
#include "core/workflow/import/import_tracks_job.h"
#include "core/workflow/shared_words.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <array>
#include <cstdio>

namespace odo {

namespace {

/// What a word of an option stands for.
template <class Value>
Result<std::optional<Value>> chosen(const CommandCall &call, const QString &option,
                                    std::optional<Value> (*valueOf)(std::string_view), const char *words)
{
    if (!call.isSet(option))
        return std::optional<Value>();
    const auto value = valueOf(call.value(option));
    if (!value)
        return call.isNoneOf(option, words);
    return value;
}

Result<std::optional<double>> lengthOf(const CommandCall &call, const QString &option)
{
    if (!call.isSet(option))
        return std::optional<double>();
    return call.lengthM(option).map([](double length) { return std::optional(length); });
}

/// Standard input as a file, which can be read twice.
class PipedTrack
{
public:
    Result<std::filesystem::path> read()
    {
        const QString name = m_folder.filePath(QStringLiteral("track"));
        QFile file(name);
        if (!m_folder.isValid() || !file.open(QIODevice::WriteOnly))
            return cannotKeep(file.errorString());
        std::array<char, 1 << 16> block{};
        constexpr std::size_t most = (std::size_t(256) << 20) + 1; // a byte more than is read, to be refused
        for (std::size_t total = 0, count = 1; count > 0 && total < most; total += count) {
            count = std::fread(block.data(), 1, block.size(), stdin);
            if (file.write(block.data(), static_cast<qint64>(count)) != static_cast<qint64>(count))
                return cannotKeep(file.errorString());
        }
        if (!file.flush())
            return cannotKeep(file.errorString());
        return name.toStdString();
    }

private:
    static tl::unexpected<Error> cannotKeep(const QString &why)
    {
        return fail(ErrorCode::Io, ODO_TEXT("app.standard_input", "standard input"),
                    foreignWords(why.toStdString()), freeTemporarySpace());
    }
    QTemporaryDir m_folder;
};

QString robotText(const ImportTracksJob::Imported &one)
{
    const Profile &profile = one.analysis.profile;
    const QString counts = QStringLiteral("%1, %2, ")
                               .arg(counted(profile.points.size(), QStringLiteral("position")))
                               .arg(counted(profile.spikes.size(), QStringLiteral("spike")));
    return QString::fromStdString(one.robot.name) + QStringLiteral(": ") + counts + mainMetricsText(profile) +
           taskRemark(profile) + QStringLiteral("\n  ") + importedTrackText(one.source);
}

QJsonObject robotJson(const ImportTracksJob::Imported &one)
{
    const Profile &profile = one.analysis.profile;
    QJsonObject json{{QStringLiteral("samples"), qint64(profile.points.size())},
                     {QStringLiteral("spikes"), qint64(profile.spikes.size())},
                     {QStringLiteral("imported"), importedTrackJson(one.source)}};
    insertMainMetrics(json, profile);
    insertMeasuredTime(json, profile);
    insertTaskAnswers(json, profile);
    return json;
}

} // namespace

QJsonObject importedTrackJson(const ImportedTrack &source)
{
    return {{QStringLiteral("file"), QString::fromStdString(source.file)},
            {QStringLiteral("sha256"), QString::fromStdString(source.sha256)},
            {QStringLiteral("bytes"), qint64(source.bytes)},
            {QStringLiteral("format"), QString::fromStdString(source.format)},
            {QStringLiteral("noise_mm"), toMillimetres(source.noiseM)},
            {QStringLiteral("reading"), english(source.reading)}};
}

QString importedTrackText(const ImportedTrack &source)
{
    return QStringLiteral("imported from %1 (%2, SHA-256 %3): %4")
        .arg(QString::fromStdString(source.file), QString::fromStdString(source.format),
             QString::fromStdString(source.sha256.substr(0, 12)), english(source.reading));
}

Message adviceAsOption(const Message &advice)
{
    const std::string_view code = advice.code();
    const std::string likely = advice.arguments.empty() ? std::string() : advice.arguments.front().text;
    if (code == "exchange.choose_time_unit")
        return likely == "frame"
                   ? ODO_TEXT("app.give_frames_or_seconds",
                              "give their unit: --time-unit frame --rate 30 if they are frame numbers, or "
                              "--time-unit s")
                   : ODO_TEXT("app.give_time_unit",
                              "give their unit, likely --time-unit %1 (s, ms, us, ns, min, h, d or frame)")(
                         likely);
    if (code == "exchange.choose_likely_unit")
        return ODO_TEXT("app.give_unit",
                        "give their unit, likely --unit %1 (m, cm, mm, in, ft or px)")(likely);
    if (code == "exchange.choose_unit")
        return ODO_TEXT("app.give_a_unit", "give their unit with --unit: m, cm, mm, in, ft or px");
    if (code == "exchange.check_both_units")
        return ODO_TEXT("app.give_both_units",
                        "give the units of its times and positions: --time-unit and --unit");
    if (code == "exchange.choose_axes")
        return ODO_TEXT("app.give_axes",
                        "give the axes of the floor: --axes %1, or --axes xy if that is right")(likely);
    if (code == "exchange.choose_decimal_sign")
        return ODO_TEXT("app.give_decimal_sign", "give the decimal sign: --decimal point or --decimal comma");
    if (code == "exchange.give_rate" || code == "workflow.give_camera_rate")
        return giveRateOption();
    if (code == "exchange.give_pixel_length")
        return ODO_TEXT(
            "app.give_pixel_length",
            "give how long a pixel is on the floor, like --pixel 2mm, or another unit with --unit");
    if (code == "exchange.write_finer_times")
        return ODO_TEXT("app.give_rate_of_series",
                        "write the times with more digits, or give the frame rate of an even series, like "
                        "--rate 30");
    if (code == "analysis.give_log_offset")
        return ODO_TEXT("app.give_log_offset",
                        "give what is added to its times to have the trial's, like --offset -12.5 (seconds)");
    return advice;
}

Result<TrackReading> trackReadingOf(const CommandCall &call)
{
    TrackReading reading;
    reading.unit = ODO_TRY(chosen(call, option::unit, lengthUnitOf, "m, cm, mm, in, ft or px"));
    reading.timeUnit = ODO_TRY(timeUnitOf(call));
    reading.axes = ODO_TRY(chosen(call, option::axes, floorAxesOf, "xy, xz or yz"));
    reading.decimal = ODO_TRY(chosen(call, option::decimal, decimalSignOf, "point or comma"));
    reading.pixelM = ODO_TRY(lengthOf(call, option::pixel));
    if (call.isSet(option::minConfidence)) {
        constexpr double most = 100;
        const auto least = call.number(option::minConfidence);
        if (!least || *least < 0 || *least > most)
            return call.wrongCall(
                ODO_TEXT("app.min_confidence_is", "--min-confidence is a number from 0 to 100"));
        reading.minConfidence = *least;
    }
    if (call.isSet(option::rate)) {
        reading.rate = ODO_TRY(frameRateOf(call));
    }
    return reading;
}

Result<std::optional<TimeUnit>> timeUnitOf(const CommandCall &call)
{
    return chosen<TimeUnit>(call, option::timeUnit, timeUnitOf, "s, ms, us, ns, min, h, d or frame");
}

Result<void> refuseTrackOptions(const CommandCall &call)
{
    for (const QCommandLineOption &each : trackReadingOptions()) {
        const QString name = each.names().constFirst();
        const bool isForTimes = name == option::timeUnit && call.isSet(option::times);
        if (call.isSet(name) && !isForTimes)
            return call.lacks(name, option::track);
    }
    return {};
}

QList<QCommandLineOption> trackReadingOptions()
{
    return {{option::unit, QStringLiteral("The unit of a track's positions, if the file does not say it."),
             QStringLiteral("m|cm|mm|px|in|ft")},
            {option::timeUnit,
             QStringLiteral("The unit of its times, or of those of --times, if the file does not say it."),
             QStringLiteral("s|ms|us|ns|frame|min|h|d")},
            {option::axes, QStringLiteral("Which coordinates of a track span the floor."),
             QStringLiteral("xy|xz|yz")},
            {option::minConfidence,
             QStringLiteral("Positions of a track below it count as not measured; default: 0.6."),
             QStringLiteral("SHARE")},
            {option::sigma,
             QStringLiteral("How accurate the positions of a track are, slow errors included."),
             QStringLiteral("LENGTH")},
            {option::pixel, QStringLiteral("How long a pixel of a track is on the floor."),
             QStringLiteral("LENGTH")},
            {option::decimal, QStringLiteral("The decimal sign of a track's numbers."),
             QStringLiteral("point|comma")}};
}

Message giveRateOption()
{
    return ODO_TEXT("app.give_rate", "give the frame rate of the camera, like --rate 30");
}

Result<double> frameRateOf(const CommandCall &call)
{
    const auto framesPerSecond = call.number(option::rate);
    if (!framesPerSecond || !(*framesPerSecond >= lowestFrameRate && *framesPerSecond <= highestFrameRate))
        return call.wrongCall(
            ODO_TEXT("app.rate_is", "--rate is a number of frames a second from 0.1 to 100,000"));
    return *framesPerSecond;
}

Result<void> importTracks(const CommandCall &call)
{
    if (!call.isSet(option::trial))
        return call.wrongCall(ODO_TEXT("app.trial_and_track_needed", "--trial and --track are needed"));
    for (const QString &other : {option::video, option::times, option::robot, option::sync}) {
        if (call.isSet(other))
            return call.wrongCall(
                ODO_TEXT("app.track_goes_with",
                         "--track goes with --trial, --team and --task, not with --%1")(other.toStdString()));
    }
    ImportTracksSettings settings;
    settings.trial = call.value(option::trial);
    settings.team = call.value(option::team);
    settings.task = call.value(option::task);
    settings.reading = ODO_TRY(trackReadingOf(call));
    settings.sigmaM = ODO_TRY(lengthOf(call, option::sigma));
    const auto tracks = ODO_TRY(call.pairs(option::track));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    PipedTrack piped;
    for (const auto &[robot, file] : tracks) {
        if (file == "-" && settings.standardInput.empty())
            settings.standardInput = ODO_TRY(piped.read());
        settings.tracks.emplace_back(robot,
                                     file == "-" ? settings.standardInput : std::filesystem::path(file));
    }
    ImportTracksJob job(std::move(settings));
    if (auto done = runToEnd(job, *project, call.control()); !done) {
        done.error().advice = adviceAsOption(done.error().advice);
        return done;
    }
    QJsonObject robots;
    QStringList lines(
        QStringLiteral("Trial %1 imported, tracks: %2")
            .arg(QString::fromStdString(job.trial().name), QString::number(job.imported().size())));
    for (const ImportTracksJob::Imported &one : job.imported()) {
        robots.insert(QString::fromStdString(one.robot.name), robotJson(one));
        lines << robotText(one);
    }
    call.answer({{QStringLiteral("trial"), QString::fromStdString(job.trial().name)},
                 {QStringLiteral("views"), QJsonObject()},
                 {QStringLiteral("sync"), syncJson(job.trial())},
                 {QStringLiteral("robots"), robots},
                 {QStringLiteral("warnings"), sentencesJson(job.warnings())}},
                lines.join(u'\n'));
    for (const Message &warning : job.warnings())
        CommandCall::warn(warning);
    return {};
}

} // namespace odo
