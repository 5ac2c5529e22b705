// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/comparison_scene.h"

#include "ui/models/number_text.h"
#include "ui/models/trial_scene.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t mostFrames = 1000000; // two recordings that lie far apart

Nanoseconds alignedAt(const ComparisonScene &scene, std::size_t run)
{
    return fromSeconds(scene.compared.comparison.runs[run].aligned.timeS);
}

} // namespace

QStringList ComparisonScene::names() const
{
    QStringList names;
    for (std::size_t run = 0; run < runCount(); ++run)
        names << QString::fromStdString(name(run));
    return names;
}

Nanoseconds ComparisonScene::ownTime(std::size_t run, Nanoseconds common) const
{
    return common + alignedAt(*this, run);
}

Nanoseconds ComparisonScene::commonTime(std::size_t run, Nanoseconds own) const
{
    return own - alignedAt(*this, run);
}

std::vector<Nanoseconds> ComparisonScene::frameTimes() const
{
    Nanoseconds first = commonTime(0, profile(0).samples.front().time), last = first;
    for (std::size_t run = 0; run < runCount(); ++run) {
        first = std::min(first, commonTime(run, profile(run).samples.front().time));
        last = std::max(last, commonTime(run, profile(run).samples.back().time));
    }
    const std::vector<Sample> &samples = profile(0).samples;
    const auto intervals = static_cast<std::int64_t>(std::max<std::size_t>(1, samples.size() - 1));
    const Nanoseconds step =
        std::max({(samples.back().time - samples.front().time) / intervals, Nanoseconds(1000000),
                  (last - first) / static_cast<std::int64_t>(mostFrames)});
    std::vector<Nanoseconds> times;
    // The aligned moment is one of them.
    for (Nanoseconds time = -(-first / step) * step; time <= last; time += step)
        times.push_back(time);
    return times;
}

double ComparisonScene::distanceAt(std::size_t run, Nanoseconds common) const
{
    return compared.comparison.runs[run].distanceAtTime(toSeconds(ownTime(run, common))) -
           compared.comparison.originM;
}

const ProfilePoint *ComparisonScene::pointAt(std::size_t run, Nanoseconds common) const
{
    const std::ptrdiff_t index = pointIndexAt(profile(run), ownTime(run, common));
    return index < 0 ? nullptr : &profile(run).points[static_cast<std::size_t>(index)];
}

Eigen::AlignedBox2d ComparisonScene::floorBounds() const
{
    Eigen::AlignedBox2d box;
    for (const TrialScenePtr &scene : scenes)
        box.extend(scene->floorBounds());
    return box;
}

Result<ComparisonScenePtr> loadComparisonScene(Project &project, const CompareSettings &settings)
{
    auto trials = ODO_TRY(readComparedTrials(project, settings));
    auto compared = ODO_TRY(compareTrials(trials, settings));
    auto result = std::make_shared<ComparisonScene>();
    for (const ComparedTrial &run : trials.runs) {
        auto scene = ODO_TRY(loadTrialScene(project, run.trial.name));
        std::size_t robot = 0;
        while (scene->robots[robot].robot.id != run.analysis.robot) // the analysis is one of the scene's
            ++robot;
        result->scenes.push_back(std::move(scene));
        result->robots.push_back(robot);
    }
    result->settings = settings;
    result->trials = std::move(trials);
    result->compared = std::move(compared);
    return ComparisonScenePtr(std::move(result));
}

namespace {

class ComparisonExplanationWords
{
    Q_DECLARE_TR_FUNCTIONS(ComparisonExplanation)
};

QString nameOf(const ComparisonScene &scene, std::size_t run)
{
    return QString::fromStdString(scene.name(run));
}

/// Whether a difference is significant, with the numbers that show it.
QString significanceText(const Difference &difference)
{
    const QLocale locale;
    if (!(difference.sigma > 0))
        return difference.value == 0
                   ? ComparisonExplanationWords::tr("No difference.")
                   : ComparisonExplanationWords::tr("Both values are exact: any difference is real.");
    const QString ratio = locale.toString(std::abs(difference.value) / difference.sigma, 'f', 1);
    return difference.isSignificant()
               ? ComparisonExplanationWords::tr("%1 σ, above 1.96: without a real difference, chance would "
                                                "give this much in fewer than 5 of 100 cases.")
                     .arg(ratio)
               : ComparisonExplanationWords::tr("%1 σ, not above 1.96: the difference is not significant.")
                     .arg(ratio);
}

QString sourceText()
{
    return QStringLiteral("JCGM 100:2008, 5.1.2, G.1");
}

/// What all comparisons rest on: the path, the moment that counts as the same, the calibration, both
/// analyses.
QStringList comparisonInputs(const ComparisonScene &scene, std::size_t run)
{
    const RunComparison &comparison = scene.compared.comparison;
    QStringList lines;
    lines << (comparison.isTasksPath
                  ? ComparisonExplanationWords::tr("along the task's reference path")
                  : ComparisonExplanationWords::tr("along the path of %1").arg(nameOf(scene, 0)));
    switch (comparison.alignedBy) {
    case AlignBy::StartGate:
        lines << ComparisonExplanationWords::tr("time 0: each passes the start gate");
        break;
    case AlignBy::MotionOnset:
        lines << ComparisonExplanationWords::tr("time 0: each begins to move");
        break;
    case AlignBy::Distance:
        lines << ComparisonExplanationWords::tr("time 0: each first reaches the same point of the path");
        break;
    case AlignBy::ByHand:
        lines << ComparisonExplanationWords::tr("time 0: set by hand, to one frame");
        break;
    }
    lines << (comparison.shareCalibration
                  ? ComparisonExplanationWords::tr(
                        "both with the same registrations and robot shape: the calibration uncertainty is "
                        "common, so only its difference counts")
                  : ComparisonExplanationWords::tr("different registrations or robot shapes: the calibration "
                                                   "uncertainty counts in full for both"));
    for (const std::size_t each : {std::size_t(0), run})
        lines << analysisInputs(*scene.scenes[each], scene.robots[each]);
    lines.removeDuplicates();
    return lines;
}

QString timeWithUnit(const Difference &time)
{
    return numberText(time.value, time.sigma, QStringLiteral("s")).text();
}

} // namespace

Explanation explainDifference(const ComparisonScene &scene, std::size_t run, const MetricDifference &metric)
{
    const auto number = [&metric](std::optional<double> value, std::optional<double> sigma,
                                  bool isAtLeast = false) {
        return value ? metricNumber({metric.name, metric.unit, *value, sigma, isAtLeast}).text()
                     : ComparisonExplanationWords::tr("none");
    };
    Explanation explanation;
    explanation.what = ComparisonExplanationWords::tr("%1: %2 minus %3")
                           .arg(metricName(metric.name), nameOf(scene, run), nameOf(scene, 0));
    explanation.inputs << ComparisonExplanationWords::tr("%1: %2").arg(
        nameOf(scene, 0), number(metric.a, metric.sigmaA, metric.isAtLeastA));
    explanation.inputs << ComparisonExplanationWords::tr("%1: %2").arg(
        nameOf(scene, run), number(metric.b, metric.sigmaB, metric.isAtLeastB));
    const Explanation each =
        explainMetric(Metric{metric.name, metric.unit, 0, metric.sigmaA ? metric.sigmaA : metric.sigmaB}, {});
    if (!metric.difference) {
        explanation.value =
            metric.a && metric.b
                ? ComparisonExplanationWords::tr("none: a run was not measured all the time, and is at least "
                                                 "so large")
                : ComparisonExplanationWords::tr("only one of the two runs has it");
        explanation.formula = each.formula;
    } else {
        explanation.value = number(metric.difference->value, metric.difference->sigma);
        explanation.formula = ComparisonExplanationWords::tr("the value of %1 minus that of %2")
                                  .arg(nameOf(scene, run), nameOf(scene, 0)) +
                              u'\n' + significanceText(*metric.difference);
        if (!each.formula.isEmpty())
            explanation.formula += u'\n' + ComparisonExplanationWords::tr("Each: %1").arg(each.formula);
        explanation.uncertainty = ComparisonExplanationWords::tr(
            "√(σ₁² + σ₂²), treated as independent; where the runs share their calibration, its scale "
            "uncertainty counts only for the difference");
        explanation.source = sourceText();
    }
    explanation.inputs += comparisonInputs(scene, run);
    return explanation;
}

Explanation explainSector(const ComparisonScene &scene, std::size_t run, const SectorTimes &sector)
{
    const auto time = [](const std::optional<Difference> &of) {
        return of ? timeWithUnit(*of) : ComparisonExplanationWords::tr("not visible at one end");
    };
    Explanation explanation;
    explanation.what = ComparisonExplanationWords::tr("Sector %1 to %2: %3 minus %4")
                           .arg(sector.from.empty() ? ComparisonExplanationWords::tr("begin")
                                                    : QString::fromStdString(sector.from),
                                sector.to.empty() ? ComparisonExplanationWords::tr("end")
                                                  : QString::fromStdString(sector.to),
                                nameOf(scene, run), nameOf(scene, 0));
    const auto &difference = sector.differences.at(run);
    explanation.value = time(difference);
    explanation.formula = ComparisonExplanationWords::tr(
        "For each run, the time from its first arrival at one gate to its first arrival at the next, by its "
        "position along the common path; waiting counts.");
    if (difference)
        explanation.formula += u'\n' + significanceText(*difference);
    explanation.uncertainty =
        ComparisonExplanationWords::tr("of each arrival: σ of the position along the path divided by the "
                                       "speed; displacements at two gates count as independent");
    explanation.source = sourceText();
    explanation.inputs << ComparisonExplanationWords::tr("from %1 to %2 along the path")
                              .arg(distanceText(sector.fromM - scene.compared.comparison.originM),
                                   distanceText(sector.toM - scene.compared.comparison.originM));
    explanation.inputs << ComparisonExplanationWords::tr("%1: %2").arg(nameOf(scene, 0),
                                                                       time(sector.times.at(0)));
    explanation.inputs << ComparisonExplanationWords::tr("%1: %2").arg(nameOf(scene, run),
                                                                       time(sector.times.at(run)));
    explanation.inputs += comparisonInputs(scene, run);
    return explanation;
}

Explanation explainTimeDifference(const ComparisonScene &scene, std::size_t run, double distanceM,
                                  const Difference &difference)
{
    Explanation explanation;
    explanation.what = ComparisonExplanationWords::tr("Δt of %1 against %2 at %3")
                           .arg(nameOf(scene, run), nameOf(scene, 0), distanceText(distanceM));
    explanation.value = timeWithUnit(difference);
    explanation.formula =
        ComparisonExplanationWords::tr(
            "The time of the first arrival at this point of the common path, each from its own "
            "time 0: that of %1 minus that of %2. Positive means later.")
            .arg(nameOf(scene, run), nameOf(scene, 0)) +
        u'\n' + significanceText(difference);
    explanation.uncertainty = ComparisonExplanationWords::tr(
        "of both arrivals: σ of the position along the path divided by the speed, and of both times 0");
    explanation.source = sourceText();
    explanation.inputs = comparisonInputs(scene, run);
    return explanation;
}

Explanation explainSpeedOverDistance(const ComparisonScene &scene, std::size_t run, double distanceM,
                                     const QString &value)
{
    Explanation explanation;
    explanation.what =
        ComparisonExplanationWords::tr("Speed of %1 at %2").arg(nameOf(scene, run), distanceText(distanceM));
    explanation.value = value;
    explanation.formula =
        ComparisonExplanationWords::tr("|v| of the smoothed curve where the run first reaches this point of "
                                       "the common path, interpolated between frames");
    explanation.uncertainty = ComparisonExplanationWords::tr(
        "σ of the smoothed velocity there, including the calibration's scale uncertainty");
    explanation.inputs = comparisonInputs(scene, run);
    return explanation;
}

namespace {

const QString dash = QStringLiteral("–");

/// "1.83 ±0.02"; the unit is beside the name.
QString bareText(NumberText number)
{
    number.unit.clear();
    return number.text();
}

/// With a plus where it is one.
QString signedText(const NumberText &number, double value)
{
    const bool hasDigits =
        std::ranges::any_of(number.value, [](QChar c) { return c.isDigit() && c.digitValue() > 0; });
    return (value > 0 && hasDigits ? QStringLiteral("+") : QString()) + bareText(number);
}

QString metricText(const MetricDifference &metric, const std::optional<double> &value,
                   const std::optional<double> &sigma, bool isAtLeast)
{
    return value ? bareText(metricNumber({metric.name, metric.unit, *value, sigma, isAtLeast})) : dash;
}

QString secondsNumber(const std::optional<Difference> &time)
{
    return time ? bareText(numberText(time->value, time->sigma, QString())) : dash;
}

} // namespace

DifferenceModel::DifferenceModel(QObject *parent) : RowTableModel(ColumnCount, parent) {}

void DifferenceModel::setMetrics(const std::vector<MetricDifference> &metrics)
{
    std::vector<Row> rows;
    for (const MetricDifference &metric : metrics) {
        const QString unit = metricNumber({metric.name, metric.unit, 0, std::nullopt}).unit;
        Row row{unit.isEmpty() ? metricName(metric.name) : tr("%1, %2").arg(metricName(metric.name), unit),
                metricText(metric, metric.a, metric.sigmaA, metric.isAtLeastA),
                metricText(metric, metric.b, metric.sigmaB, metric.isAtLeastB),
                dash,
                metric.difference.has_value(),
                false};
        if (metric.difference) {
            const Metric difference{metric.name, metric.unit, metric.difference->value,
                                    metric.difference->sigma};
            row.difference = signedText(metricNumber(difference), difference.value);
            row.isSignificant = metric.difference->isSignificant();
        }
        rows.push_back(std::move(row));
    }
    setRows(std::move(rows));
}

void DifferenceModel::setSectors(const std::vector<SectorTimes> &sectors, std::size_t run)
{
    std::vector<Row> rows;
    for (const SectorTimes &sector : sectors) {
        const QString from = sector.from.empty() ? tr("begin") : QString::fromStdString(sector.from);
        const QString to = sector.to.empty() ? tr("end") : QString::fromStdString(sector.to);
        const auto &difference = sector.differences[run];
        Row row{tr("%1 to %2").arg(from, to),     secondsNumber(sector.times[0]),
                secondsNumber(sector.times[run]), dash,
                difference.has_value(),           difference && difference->isSignificant()};
        if (difference)
            row.difference =
                signedText(numberText(difference->value, difference->sigma, QString()), difference->value);
        rows.push_back(std::move(row));
    }
    setRows(std::move(rows));
}

void DifferenceModel::setRows(std::vector<Row> rows)
{
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

void DifferenceModel::setRunNames(const QString &first, const QString &second)
{
    m_first = first;
    m_second = second;
    Q_EMIT headerDataChanged(Qt::Horizontal, FirstColumn, SecondColumn);
}

QVariant DifferenceModel::cell(int index, int column, int role) const
{
    const Row &row = m_rows[static_cast<std::size_t>(index)];
    switch (role) {
    case Qt::DisplayRole:
        return column == NameColumn    ? row.name
               : column == FirstColumn ? row.first
               : column == SecondColumn
                   ? row.second
                   : (row.isCompared && !row.isSignificant ? QStringLiteral("≈ ") : QString()) +
                         row.difference;
    case Qt::ToolTipRole:
        if (!row.isCompared)
            return tr("Only one of the two runs has it");
        return row.isSignificant ? tr("%1: significant (95 %)").arg(row.name)
                                 : tr("%1: not significant (95 %)").arg(row.name);
    case Qt::AccessibleDescriptionRole:
        return !row.isCompared ? QString() : row.isSignificant ? tr("significant") : tr("not significant");
    case Qt::TextAlignmentRole:
        return aligned(column == NameColumn ? Qt::AlignLeft : Qt::AlignRight);
    case SignificantRole:
        return row.isSignificant;
    default:
        return {};
    }
}

QVariant DifferenceModel::heading(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return aligned(column == NameColumn ? Qt::AlignLeft : Qt::AlignRight);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case FirstColumn:
        return m_first;
    case SecondColumn:
        return m_second;
    case DifferenceColumn:
        return tr("Difference");
    default:
        return QString();
    }
}

} // namespace odo
