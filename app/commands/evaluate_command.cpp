// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/commands/trial_commands.h"
#include "core/workflow/compare/evaluate_log.h"
#include "core/workflow/track/track_warnings.h"

#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double degreesPerRadian = 180 / std::numbers::pi;
constexpr double million = 1e6;

/// factor: from SI to the unit that is printed.
QJsonObject statisticsJson(const std::optional<ErrorStatistics> &errors, double factor)
{
    const auto scaled = [&](double ErrorStatistics::*value) {
        return errors ? QJsonValue(factor * (*errors).*value) : QJsonValue();
    };
    return {{QStringLiteral("rmse"), scaled(&ErrorStatistics::rmse)},
            {QStringLiteral("mean"), scaled(&ErrorStatistics::mean)},
            {QStringLiteral("median"), scaled(&ErrorStatistics::median)},
            {QStringLiteral("std"), scaled(&ErrorStatistics::std)},
            {QStringLiteral("min"), scaled(&ErrorStatistics::least)},
            {QStringLiteral("max"), scaled(&ErrorStatistics::most)},
            {QStringLiteral("count"), qint64(errors ? errors->count : 0)},
            {QStringLiteral("measurement_sigma"), scaled(&ErrorStatistics::measurementSigma)},
            {QStringLiteral("within_uncertainty"),
             errors ? QJsonValue(errors->isWithinUncertainty()) : QJsonValue()}};
}

QJsonObject evaluationJson(const EvaluateSettings &settings, const EvaluatedLog &evaluated)
{
    const LogEvaluation &result = evaluated.evaluation;
    const LogClock &clock = result.clock;
    QJsonObject rpe = statisticsJson(result.rpe, 1);
    rpe.insert(QStringLiteral("delta"), settings.deltaM);
    rpe.insert(QStringLiteral("of"),
               result.isRpeOfPoses ? QStringLiteral("poses") : QStringLiteral("displacements"));
    const PlaneSimilarity &transform = result.transform;
    QJsonObject json{
        {QStringLiteral("trial"), QString::fromStdString(settings.trial)},
        {QStringLiteral("robot"), QString::fromStdString(settings.robot)},
        {QStringLiteral("format"), QString::fromStdString(std::string(trackFormatWord(evaluated.format)))},
        {QStringLiteral("reading"), sentencesJson(evaluated.facts)},
        {QStringLiteral("aligned_by"), QString::fromStdString(std::string(wordOf(result.alignment)))},
        {QStringLiteral("time_offset_s"), evaluated.offsetS},
        {QStringLiteral("time_offset_sigma_s"),
         clock.isGiven ? QJsonValue() : QJsonValue(clock.sigmaOffsetS)},
        {QStringLiteral("clock_rate_ppm"), million * clock.rate},
        {QStringLiteral("clock_rate_sigma_ppm"),
         clock.sigmaRate > 0 ? QJsonValue(million * clock.sigmaRate) : QJsonValue()},
        {QStringLiteral("samples"), qint64(result.ape.count)},
        {QStringLiteral("left_out"), QJsonObject{{QStringLiteral("in_gaps"), qint64(result.inGaps)},
                                                 {QStringLiteral("outside"), qint64(result.outside)}}},
        {QStringLiteral("ape_m"), statisticsJson(result.ape, 1)},
        {QStringLiteral("rpe_m"), rpe},
        {QStringLiteral("heading_deg"), statisticsJson(result.heading, degreesPerRadian)},
        {QStringLiteral("path_length_m"), result.pathM},
        {QStringLiteral("drift_percent"), result.driftPercent},
        {QStringLiteral("drift_sigma_percent"), result.sigmaDriftPercent},
        {QStringLiteral("transform"), QJsonObject{{QStringLiteral("x_m"), transform.shiftM.x()},
                                                  {QStringLiteral("y_m"), transform.shiftM.y()},
                                                  {QStringLiteral("heading_rad"), transform.headingRad},
                                                  {QStringLiteral("scale"), transform.scale}}},
        {QStringLiteral("warnings"), sentencesJson(evaluated.warnings)}};
    if (result.alignment == LogAlignment::Origin)
        json.insert(QStringLiteral("origin_heading_by"),
                    result.isTurnedByHeading ? QStringLiteral("heading") : QStringLiteral("path"));
    return json;
}

QString clockText(const EvaluatedLog &evaluated)
{
    const LogClock &clock = evaluated.evaluation.clock;
    QString text = QStringLiteral("Time offset: %1 s").arg(evaluated.offsetS, 0, 'f', 4);
    text += clock.isGiven ? QStringLiteral(", as given")
                          : QStringLiteral(" ±%1 ms").arg(1000 * clock.sigmaOffsetS, 0, 'f', 2);
    if (clock.rate != 0)
        text += QStringLiteral("; the log's clock is %1 by %2 ppm ±%3 ppm")
                    .arg(clock.rate > 0 ? QStringLiteral("slow") : QStringLiteral("fast"))
                    .arg(million * std::abs(clock.rate), 0, 'f', 0)
                    .arg(million * clock.sigmaRate, 0, 'f', 0);
    return text;
}

QString countText(const LogEvaluation &result, std::size_t positions)
{
    QString text = QStringLiteral("%1 of %2 positions compared").arg(result.ape.count).arg(positions);
    if (result.outside > 0)
        text += QStringLiteral(", %1 outside the run").arg(result.outside);
    if (result.inGaps > 0)
        text += QStringLiteral(", %1 in gaps of the measurement").arg(result.inGaps);
    return text;
}

/// "Absolute error: rms 12.3 mm, …".
QString statisticsText(const QString &what, const ErrorStatistics &errors, double factor, const QString &unit,
                       int decimals)
{
    const auto number = [&](double value) { return QString::number(factor * value, 'f', decimals); };
    const QString text =
        QStringLiteral("%1: rms %2 %9, mean %3, median %4, standard deviation %5, from %6 to %7 %9; "
                       "uncertainty of the measurement %8 %9")
            .arg(what, number(errors.rmse), number(errors.mean), number(errors.median), number(errors.std),
                 number(errors.least), number(errors.most), number(errors.measurementSigma), unit);
    return errors.isWithinUncertainty()
               ? text + QStringLiteral(" (not significant: within the uncertainty of the measurement)")
               : text;
}

QString alignmentText(const LogEvaluation &result)
{
    const PlaneSimilarity &transform = result.transform;
    switch (result.alignment) {
    case LogAlignment::None:
        return QStringLiteral("Aligned by none: the log counts as in the axes of the floor");
    case LogAlignment::Origin:
    case LogAlignment::Se2:
    case LogAlignment::Sim2:
        break;
    }
    QString text = QStringLiteral("Aligned by %1: turned by %2°, shifted by %3, %4 m")
                       .arg(QString::fromStdString(std::string(wordOf(result.alignment))))
                       .arg(degreesPerRadian * transform.headingRad, 0, 'f', 2)
                       .arg(transform.shiftM.x(), 0, 'f', 3)
                       .arg(transform.shiftM.y(), 0, 'f', 3);
    if (result.alignment == LogAlignment::Sim2)
        text += QStringLiteral(", scaled by %1").arg(transform.scale, 0, 'f', 5);
    return text;
}

QString evaluationText(const EvaluateSettings &settings, const EvaluatedLog &evaluated)
{
    const LogEvaluation &result = evaluated.evaluation;
    QStringList lines{QStringLiteral("%1 in trial %2 by its own log: %3")
                          .arg(QString::fromStdString(settings.robot), QString::fromStdString(settings.trial),
                               countText(result, evaluated.positions)),
                      clockText(evaluated), alignmentText(result)};
    lines << statisticsText(QStringLiteral("Absolute error"), result.ape, millimetresPerMetre,
                            QStringLiteral("mm"), 1);
    if (result.rpe)
        lines << statisticsText(QStringLiteral("Relative error over %1 m (%2 stretches)")
                                    .arg(settings.deltaM, 0, 'g', 4)
                                    .arg(result.rpe->count),
                                *result.rpe, millimetresPerMetre, QStringLiteral("mm"), 1);
    if (result.heading)
        lines << statisticsText(QStringLiteral("Heading error"), *result.heading, degreesPerRadian,
                                QStringLiteral("°"), 2);
    else
        lines << QStringLiteral("Heading error: not known, as not both have headings");
    lines << QStringLiteral("Drift: %1 % ±%2 % of %3 m")
                 .arg(result.driftPercent, 0, 'f', 2)
                 .arg(result.sigmaDriftPercent, 0, 'f', 2)
                 .arg(result.pathM, 0, 'f', 3);
    return lines.join(u'\n');
}

QList<QCommandLineOption> evaluateOptions()
{
    QList<QCommandLineOption> options{
        {option::robot, QStringLiteral("The robot whose log it is."), QStringLiteral("R")},
        {option::log, QStringLiteral("The robot's own log: TUM, CSV, Tracker text and others."),
         QStringLiteral("FILE")},
        {option::align,
         QStringLiteral("How the log is put into the floor's axes: not at all, by its first pose, or turned "
                        "and shifted (sim2: and scaled) for the least errors."),
         QStringLiteral("none|origin|se2|sim2"), QStringLiteral("se2")},
        {option::delta, QStringLiteral("The distance travelled over which the relative error is taken."),
         QStringLiteral("LENGTH"), QStringLiteral("1m")},
        {option::offset,
         QStringLiteral("What is added to the log's times to have the trial's; default: estimated."),
         QStringLiteral("SECONDS")},
        {option::rate, QStringLiteral("The frame rate, if the log has only frame numbers."),
         QStringLiteral("FPS")}};
    for (const QCommandLineOption &each : trackReadingOptions())
        if (!each.names().contains(option::sigma))
            options << each;
    return options;
}

Result<EvaluateSettings> evaluateSettings(const CommandCall &call)
{
    if (!call.isSet(option::robot))
        return call.missing(option::robot);
    if (!call.isSet(option::log))
        return call.missing(option::log);
    EvaluateSettings settings;
    settings.trial = call.text(1);
    settings.robot = call.value(option::robot);
    settings.log = call.value(option::log);
    settings.reading = ODO_TRY(trackReadingOf(call));
    const auto alignment = logAlignmentOf(call.value(option::align));
    if (!alignment)
        return call.isNoneOf(option::align, "none, origin, se2 or sim2");
    settings.alignment = *alignment;
    settings.deltaM = ODO_TRY(call.lengthM(option::delta));
    if (call.isSet(option::offset)) {
        settings.offsetS = ODO_TRY(call.number(option::offset));
    }
    return settings;
}

} // namespace

Result<void> runEvaluate(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("evaluate"),
                      QStringLiteral("P.odo TRIAL --robot R --log FILE [--align none|origin|se2|sim2] "
                                     "[--delta 1m] [--offset SECONDS] [--unit UNIT] [--time-unit UNIT] "
                                     "[--axes xz] [--min-confidence 0.6] [--rate 30] [--pixel 2mm] "
                                     "[--decimal comma] [--json]"),
                      2, 2, evaluateOptions()},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const EvaluateSettings settings = ODO_TRY(evaluateSettings(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const auto run = ODO_TRY(
        readComparedTrial(*project, {settings.trial, settings.robot}, evaluationSubject(settings.trial)));
    auto evaluated = evaluateLogFile(run, settings, call.control());
    if (!evaluated) {
        evaluated.error().advice = adviceAsOption(evaluated.error().advice);
        return tl::unexpected(evaluated.error());
    }
    QJsonObject json = evaluationJson(settings, *evaluated);
    json.insert(QStringLiteral("range"), rangeJson(run.trial));
    QString text = evaluationText(settings, *evaluated);
    if (run.trial.range)
        text += u'\n' + english(rangeSentence(run.trial));
    call.answer(json, text);
    for (const Message &warning : evaluated->warnings)
        CommandCall::warn(warning);
    for (const Message &warning : analysisWarnings(run.analysis, run.trial.name))
        CommandCall::warn(warning);
    return {};
}

} // namespace odo
