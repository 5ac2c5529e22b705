// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/command_output.h"
#include "app/commands/commands.h"
#include "core/exchange/trial_json.h"
#include "core/project/names.h"
#include "core/workflow/compare/compare_trials.h"
#include "core/workflow/track/track_warnings.h"
#include "ui/report/report_output.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <cmath>

namespace odo {

namespace {

QList<QCommandLineOption> reportSyntax()
{
    return outputOptions(QStringLiteral("The PDF file to write.")) +
           QList<QCommandLineOption>{
               {option::ofClass, QStringLiteral("Starts with the ranking of this class."),
                QStringLiteral("CLASS")},
               {option::task, QStringLiteral("The task to rank by; default: the task of most of its trials."),
                QStringLiteral("TASK")},
               {option::metric,
                QStringLiteral(
                    "The metric to rank by; default: the score, or else the most informative metric."),
                QStringLiteral("METRIC")},
               {option::teams, QStringLiteral("Adds a page for each team of the class.")}} +
           reportOptionSyntax();
}

} // namespace

Result<void> runReport(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("report"),
                      QStringLiteral("P.odo [TRIAL]... -o report.pdf [--force] [--class CLASS]"), 1, -1,
                      reportSyntax()},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output))
        return call.missing(option::output);
    const bool hasTrials = call.positionals().size() > 1;
    if (!hasTrials && !call.isSet(option::ofClass))
        return call.wrongCall(ODO_TEXT("app.name_trial_or_class", "name a trial, or a class with --class"));
    if (!call.isSet(option::ofClass))
        for (const QString &needsClass : {option::task, option::metric, option::teams})
            if (call.isSet(needsClass))
                return call.lacks(needsClass, option::ofClass);
    const auto options = ODO_TRY(readReportOptions(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const QString file = QString::fromStdString(call.value(option::output));
    const auto output = ODO_TRY(CommandOutput::of(call, file, FileKind::Pdf, project.get()));
    std::vector<ReportMaker> makers;
    if (call.isSet(option::ofClass))
        makers.push_back(classReport({call.value(option::ofClass), call.value(option::task),
                                      call.value(option::metric), call.isSet(option::teams)},
                                     options));
    if (hasTrials) {
        std::vector<std::string> trials;
        for (const QString &trial : call.positionals().mid(1))
            trials.push_back(trial.toStdString());
        makers.push_back(trialReports(std::move(trials), options));
    }
    ReportJob job(inTurn(std::move(makers)),
                  std::make_unique<PdfFile>(output.target(), QStringLiteral("Odograph report")));
    ODO_TRY(runToEnd(job, *project, call.control()));
    return output.finish(
        call, {{QStringLiteral("report"), file}, {QStringLiteral("pages"), job.pageCount()}},
        QStringLiteral("Wrote %1, %2.").arg(file, counted(job.pageCount(), QStringLiteral("page"))));
}

namespace {

/// The value of --align: a word, or the seconds by which the second run's moment comes later in its
/// recording.
Result<void> readAlignment(const CommandCall &call, CompareSettings &settings, double &laterS)
{
    const std::string word = call.value(option::align);
    if (word == "auto")
        return {};
    for (const AlignBy by : {AlignBy::StartGate, AlignBy::MotionOnset, AlignBy::Distance}) {
        if (word != alignByWord(by))
            continue;
        settings.alignBy = by;
        return {};
    }
    const auto seconds = call.number(option::align);
    if (!seconds)
        return call.wrongCall(ODO_TEXT(
            "app.align_is", "--align is auto, start_gate, motion_onset, distance or a number of seconds"));
    if (std::abs(*seconds) > largestOffsetS)
        return call.wrongCall(
            ODO_TEXT("app.align_takes_seconds", "--align takes seconds from -3600 to 3600"));
    settings.alignBy = AlignBy::ByHand;
    laterS = *seconds;
    return {};
}

QJsonArray metricsJson(const std::vector<MetricDifference> &lines)
{
    QJsonArray metrics;
    for (const MetricDifference &line : lines) {
        if (!line.difference) // a metric that only one of them has, or a lower bound, cannot be compared
            continue;
        metrics.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(line.name)},
                                   {QStringLiteral("unit"), QString::fromStdString(line.unit)},
                                   {QStringLiteral("a"), *line.a},
                                   {QStringLiteral("b"), *line.b},
                                   {QStringLiteral("difference"), line.difference->value},
                                   {QStringLiteral("sigma"), line.difference->sigma},
                                   {QStringLiteral("significant"), line.difference->isSignificant()}});
    }
    return metrics;
}

QJsonObject comparisonJson(const TrialComparison &compared)
{
    const std::string_view alignedBy = alignByWord(compared.comparison.alignedBy);
    QJsonArray distances, differences;
    for (std::size_t station = 0; station < compared.comparison.distancesM.size(); ++station) {
        const auto difference = compared.comparison.timeDifference(1, station);
        if (!difference) // one of the runs was never there
            continue;
        distances.append(compared.comparison.distanceM(station));
        differences.append(difference->value);
    }
    return {{QStringLiteral("aligned_by"), QString::fromUtf8(alignedBy.data(), qsizetype(alignedBy.size()))},
            {QStringLiteral("distance_m"), distances},
            {QStringLiteral("delta_t_s"), differences},
            {QStringLiteral("metrics"), metricsJson(compared.metrics.front())}};
}

QString alignmentWords(AlignBy by)
{
    switch (by) {
    case AlignBy::StartGate:
        return QStringLiteral("the start gate");
    case AlignBy::MotionOnset:
        return QStringLiteral("the onset of motion");
    case AlignBy::Distance:
        return QStringLiteral("a position that both pass");
    case AlignBy::ByHand:
        break;
    }
    return QStringLiteral("hand");
}

/// "+0.123 ±0.004 s", and whether chance explains it.
QString differenceText(const Difference &difference, const QString &unit)
{
    const int decimals = difference.sigma > 0 && difference.sigma < 0.0005 ? 4 : 3;
    return QStringLiteral("%1%2 ±%3%4%5")
        .arg(difference.value < 0 ? QString() : QStringLiteral("+"))
        .arg(difference.value, 0, 'f', decimals)
        .arg(difference.sigma, 0, 'f', decimals)
        .arg(unit == QStringLiteral("1") ? QString() : u' ' + unit,
             difference.isSignificant() ? QString() : QStringLiteral("  not significant"));
}

QString valueText(const std::optional<double> &value)
{
    return value ? QString::number(*value, 'f', 3) : QStringLiteral("-");
}

QString comparisonText(const ComparedTrials &trials, const TrialComparison &compared)
{
    const RunComparison &comparison = compared.comparison;
    const QString a = QString::fromStdString(runName(trials.runs[0])),
                  b = QString::fromStdString(runName(trials.runs[1]));
    QStringList lines(
        QStringLiteral("%1 (a) and %2 (b), aligned by %3, along %4; differences are b minus a, ± one σ")
            .arg(a, b, alignmentWords(comparison.alignedBy),
                 comparison.isTasksPath ? QStringLiteral("the task's path")
                                        : QStringLiteral("the path of a")));
    for (std::size_t station = comparison.distancesM.size(); station-- > 0;) {
        if (const auto last = comparison.timeDifference(1, station)) {
            lines << QStringLiteral("  after %1 m: %2")
                         .arg(comparison.distanceM(station), 0, 'f', 2)
                         .arg(differenceText(*last, QStringLiteral("s")));
            break;
        }
    }
    for (const SectorTimes &sector : compared.sectors) {
        if (!sector.differences[1])
            continue;
        lines << QStringLiteral("  %1 to %2: %3 s, %4 s, %5")
                     .arg(sector.from.empty() ? QStringLiteral("beginning")
                                              : QString::fromStdString(sector.from),
                          sector.to.empty() ? QStringLiteral("end") : QString::fromStdString(sector.to))
                     .arg(sector.times[0]->value, 0, 'f', 3)
                     .arg(sector.times[1]->value, 0, 'f', 3)
                     .arg(differenceText(*sector.differences[1], QStringLiteral("s")));
    }
    for (const MetricDifference &line : compared.metrics.front())
        lines << QStringLiteral("  %1 %2 %3  %4")
                     .arg(QString::fromStdString(line.name), -16)
                     .arg(valueText(line.a), 9)
                     .arg(valueText(line.b), 9)
                     .arg(line.difference
                              ? differenceText(*line.difference, QString::fromStdString(line.unit))
                          : (line.isAtLeastA || line.isAtLeastB) ? QStringLiteral("at least so large")
                                                                 : QStringLiteral("only one has it"));
    return lines.join(u'\n');
}

/// Nothing where none was asked for.
Result<std::optional<CommandOutput>> reportOutput(const CommandCall &call, Project &project)
{
    if (!call.isSet(option::output))
        return std::nullopt;
    return CommandOutput::of(call, QString::fromStdString(call.value(option::output)), FileKind::Pdf,
                             &project)
        .map([](CommandOutput output) { return std::optional(std::move(output)); });
}

Result<void> writeReport(const CommandCall &call, Project &project, const CompareSettings &settings,
                         const OutputTarget &target)
{
    const auto options = ODO_TRY(readReportOptions(call));
    ReportJob job(comparisonReport(settings, options),
                  std::make_unique<PdfFile>(target, QStringLiteral("Odograph comparison")));
    return runToEnd(job, project, call.control());
}

} // namespace

namespace {

void addRangesAndVerdicts(const ComparedTrials &trials, QJsonObject &json, QString &words)
{
    QJsonArray verdicts;
    QJsonArray ranges;
    for (const ComparedTrial &run : trials.runs) {
        ranges.append(rangeJson(run.trial));
        if (run.trial.range)
            words += QStringLiteral("\n%1: %2")
                         .arg(QString::fromStdString(runName(run)), english(rangeSentence(run.trial)));
        verdicts.append(verdictJson(run.verdict));
        if (run.verdict.checks.empty())
            continue;
        words += QStringLiteral("\n%1:").arg(QString::fromStdString(runName(run)));
        for (const QString &line : verdictLines(run.verdict))
            words += QStringLiteral("\n  ") + line;
    }
    json.insert(QStringLiteral("ranges"), ranges);
    json.insert(QStringLiteral("verdicts"), verdicts);
}

} // namespace

Result<void> runCompare(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("compare"),
         QStringLiteral(
             "P.odo TRIAL1 TRIAL2 [--robot R]... [--align auto|start_gate|motion_onset|distance|SECONDS] "
             "[-o report.pdf [--force]]"),
         3, 3,
         outputOptions(QStringLiteral("The PDF report to write.")) +
             QList<QCommandLineOption>{
                 {option::robot,
                  QStringLiteral("The robot, if a trial has several: one for both trials, or one for each."),
                  QStringLiteral("R")},
                 {option::align,
                  QStringLiteral("The moment to align by; SECONDS: how much later it comes in TRIAL2's "
                                 "recording than in TRIAL1's."),
                  QStringLiteral("HOW"), QStringLiteral("auto")}} +
             reportOptionSyntax()},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const std::vector<std::string> robots = call.texts(option::robot);
    if (robots.size() > 2)
        return call.wrongCall(
            ODO_TEXT("app.robot_once_or_twice", "--robot is given once for both trials, or once for each"));
    CompareSettings settings;
    settings.runs = {{call.text(1), robots.empty() ? std::string() : robots.front()},
                     {call.text(2), robots.empty() ? std::string() : robots.back()}};
    double laterS = 0;
    ODO_TRY(readAlignment(call, settings, laterS));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const auto report = ODO_TRY(reportOutput(call, *project));
    const auto trials = ODO_TRY(readComparedTrials(*project, settings));
    settings.handTimesS = {std::max(0.0, -laterS), std::max(0.0, laterS)};
    const auto compared = ODO_TRY(compareTrials(trials, settings));
    if (report)
        ODO_TRY(writeReport(call, *project, settings, report->target()));
    QJsonObject json = comparisonJson(compared);
    QString words = comparisonText(trials, compared);
    addRangesAndVerdicts(trials, json, words);
    if (report) {
        ODO_TRY(report->finish(call, json, words));
    } else {
        call.answer(json, words);
    }
    for (const ComparedTrial &run : trials.runs)
        for (const Message &warning : analysisWarnings(run.analysis, run.trial.name))
            CommandCall::warn(warning);
    return {};
}

} // namespace odo
