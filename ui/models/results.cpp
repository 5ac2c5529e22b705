// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/results.h"

#include "core/analysis/metric_table.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_names.h"
#include "ui/models/trial_scene.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <string>

namespace odo {

std::vector<Metric> informativeMetrics(const std::vector<Metric> &all, std::size_t count)
{
    std::vector<Metric> chosen;
    for (const MetricKind &kind : metricKinds()) {
        const auto found = std::ranges::find(all, kind.id, &Metric::name);
        if (found != all.end())
            chosen.push_back(*found);
    }
    for (const Metric &metric : all) {
        if (std::ranges::find(chosen, metric.name, &Metric::name) == chosen.end())
            chosen.push_back(metric);
    }
    chosen.resize(std::min(chosen.size(), count));
    return chosen;
}

std::vector<std::string> informativeMetricNames(const std::vector<std::string> &names)
{
    std::vector<Metric> known;
    for (const std::string &name : names)
        known.push_back({name, {}, 0, {}});
    std::vector<std::string> ordered;
    for (Metric &metric : informativeMetrics(known, known.size()))
        ordered.push_back(std::move(metric.name));
    return ordered;
}

namespace {

class ScoreTextWords
{
    Q_DECLARE_TR_FUNCTIONS(ScoreText)
};

QString tenths(double points)
{
    return QLocale().toString(std::round(points * 10) / 10, 'f', 1);
}

/// Tenths of a point at the finest.
QString pointsText(double points)
{
    return std::abs(points - std::round(points)) < 0.05 ? QLocale().toString(std::round(points), 'f', 0)
                                                        : tenths(points);
}

/// With its σ where that is seen in tenths, both of which then show them.
NumberText pointsNumber(double points, double sigma, const QString &unit = {})
{
    return sigma < 0.05 ? NumberText{pointsText(points), {}, unit}
                        : NumberText{tenths(points), tenths(sigma), unit};
}

QString boundText(const std::string &metric, double value)
{
    const BoundUnit unit = boundUnit(metric);
    const QString number = QLocale().toString(unit.factor * value, 'g', 6);
    return unit.unit.isEmpty() ? number : number + QChar(u'\u00a0') + unit.unit;
}

QString lineText(const CriterionScore &line)
{
    const QString name = metricName(line.criterion.metric), rule = criterionText(line.criterion);
    if (!line.metric)
        return ScoreTextWords::tr("%1: not measured, no points (%2)").arg(name, rule);
    const QString valueText = metricNumber(*line.metric).text();
    if (line.criterion.points < 0)
        return ScoreTextWords::tr("%1 %2: %3 points (%4)")
            .arg(name, valueText, pointsNumber(line.points, line.sigma).text(), rule);
    return ScoreTextWords::tr("%1 %2: %3 of %4 points (%5)")
        .arg(name, valueText, pointsNumber(line.points, line.sigma).text(), pointsText(line.criterion.points),
             rule);
}

} // namespace

BoundUnit boundUnit(const std::string &metric)
{
    const MetricKind *kind = metricKind(metric);
    if (!kind)
        return {};
    const ShownUnit unit = metricUnit({metric, std::string(kind->unit), 0, {}});
    return {unit.name, unit.perSi};
}

QString scoreText(const Score &score)
{
    return ScoreTextWords::tr("%1 of %2")
        .arg(pointsNumber(score.points, score.sigma).text(), pointsText(score.most));
}

NumberText scoreNumber(const Score &score)
{
    return pointsNumber(score.points, score.sigma, ScoreTextWords::tr("of %1").arg(pointsText(score.most)));
}

Explanation explainScore(const Score &score, const QStringList &inputs)
{
    Explanation explanation;
    explanation.what = metricName("score");
    explanation.value = scoreText(score);
    explanation.formula =
        ScoreTextWords::tr("the sum of the points of each line; a line gives points × (metric − "
                           "none at) / (all at − none at), from 0 to all");
    explanation.uncertainty =
        ScoreTextWords::tr("for each line, half the difference in points between its metric "
                           "plus and minus one σ; root of the sum of the squares");
    explanation.inputs = scoreLines(score) + inputs;
    return explanation;
}

QString criterionText(const Criterion &criterion)
{
    const QString full = boundText(criterion.metric, criterion.fullAt),
                  none = boundText(criterion.metric, criterion.noneAt);
    const QString points = pointsText(std::abs(criterion.points));
    const bool less = criterion.fullAt < criterion.noneAt;
    if (criterion.points < 0)
        return less ? ScoreTextWords::tr("%1 points off at %2 or less, none off at %3 or more")
                          .arg(points, full, none)
                    : ScoreTextWords::tr("%1 points off at %2 or more, none off at %3 or less")
                          .arg(points, full, none);
    return less ? ScoreTextWords::tr("%1 points at %2 or less, none at %3 or more").arg(points, full, none)
                : ScoreTextWords::tr("%1 points at %2 or more, none at %3 or less").arg(points, full, none);
}

QStringList scoreLines(const Score &score)
{
    QStringList lines;
    for (const CriterionScore &line : score.lines)
        lines << lineText(line);
    return lines;
}

bool isMeasuredOtherwise(const TrialScene &scene, std::size_t robot)
{
    const std::optional<AnalysisRecord> &analysis = scene.robots.at(robot).analysis;
    return analysis && scene.task && hasCourse(*scene.task) && analysis->task != scene.taskId;
}

std::optional<Score> scoreOf(const TrialScene &scene, std::size_t robot)
{
    const std::optional<AnalysisRecord> &analysis = scene.robots.at(robot).analysis;
    if (scene.scoring.empty() || !analysis || isMeasuredOtherwise(scene, robot))
        return std::nullopt;
    std::vector<Metric> metrics = analysis->profile.metrics;
    std::ranges::copy(scoringMetrics(analysis->profile.spikes, analysis->profile.passages),
                      std::back_inserter(metrics));
    return scoreOf(scene.scoring, metrics);
}

namespace {

QString valueText(const TeamStanding &team, double value, std::optional<double> sigma)
{
    Metric metric = team.runs.front().metric; // its name and unit
    metric.value = value;
    metric.sigma = sigma;
    return metricNumber(metric).text();
}

} // namespace

QString progressText(const TeamStanding &team, const Standings &standings)
{
    if (!standings.isRanked())
        return StandingsModel::tr("choose a task");
    if (!team.progress.change)
        return StandingsModel::tr("needs three trials at different times");
    const UncertainValue change = *team.progress.change;
    const QString by = valueText(team, change.value, change.sigma);
    if (!team.progress.isBeyondSpread)
        return StandingsModel::tr("within the spread (%1)").arg(by);
    const bool better = (change.value < 0) == standings.isLessBetter;
    return better ? StandingsModel::tr("better: %1").arg(by) : StandingsModel::tr("worse: %1").arg(by);
}

StandingsModel::StandingsModel(QObject *parent) : RowTableModel(ColumnCount, parent) {}

void StandingsModel::setStandings(Standings standings)
{
    beginResetModel();
    m_standings = std::move(standings);
    endResetModel();
}

QString StandingsModel::teamName(int row) const
{
    const TeamStanding &team = this->team(row);
    return shownTeam(team.team, team.pseudonym);
}

QString StandingsModel::display(const TeamStanding &team, int row, int column) const
{
    switch (column) {
    case RankColumn:
        return m_standings.isRanked() ? QLocale().toString(team.statistics.rank) : QStringLiteral("–");
    case TeamColumn:
        return teamName(row);
    case ClassColumn:
        return QString::fromStdString(team.className);
    case RunsColumn: {
        const QString runs = QLocale().toString(team.progress.count);
        const int doubtful = team.doubtfulRuns();
        return doubtful == 0 ? runs : tr("%1, %n doubtful", "", doubtful).arg(runs);
    }
    case BestColumn:
        return valueText(team, team.progress.best, std::nullopt);
    case MedianColumn:
        return valueText(team, team.statistics.median,
                         team.statistics.sigma > 0 ? std::optional(team.statistics.sigma) : std::nullopt);
    case SpreadColumn:
        return team.progress.spread ? valueText(team, *team.progress.spread, std::nullopt) : tr("one trial");
    case ProgressColumn:
        return progressText(team, m_standings);
    default:
        return {};
    }
}

QVariant StandingsModel::cell(int index, int column, int role) const
{
    if (role == Qt::DisplayRole)
        return display(team(index), index, column);
    if (role == Qt::TextAlignmentRole) {
        const bool isText = column == TeamColumn || column == ClassColumn || column == ProgressColumn;
        return aligned(isText ? Qt::AlignLeft : Qt::AlignRight);
    }
    return {};
}

QVariant StandingsModel::heading(int column, int role) const
{
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const bool tip = role == Qt::ToolTipRole;
    switch (column) {
    case RankColumn:
        return tip ? tr("One more than the number of significantly better teams (medians differ by more than "
                        "1.96 σ). Runs of different tasks are not ranked")
                   : tr("Rank");
    case TeamColumn:
        return tr("Team");
    case ClassColumn:
        return tr("Class");
    case RunsColumn:
        return tip ? tr("Those with bad results do not count") : tr("Trials");
    case BestColumn:
        return tr("Best");
    case MedianColumn:
        return tip ? tr("± from the spread of all teams' trials, at least that of the measurement")
                   : tr("Median");
    case SpreadColumn:
        return tip ? tr("Repeatability: standard deviation of one trial about the line of progress")
                   : tr("Spread");
    case ProgressColumn:
        return tip ? tr("Change over the term by a straight-line fit; Student's t-test (95 %) decides if it "
                        "exceeds the spread")
                   : tr("Progress");
    default:
        return {};
    }
}

} // namespace odo
