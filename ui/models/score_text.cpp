// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/score_text.h"

#include "ui/models/figure_text.h"
#include "ui/models/trial_scene.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

class Words
{
    Q_DECLARE_TR_FUNCTIONS(ScoreText)
};

/// Points are counted in halves at the finest; their σ says how much of that is worth anything.
QString pointsText(double points)
{
    return QLocale().toString(std::round(points * 10) / 10, 'f', std::abs(points - std::round(points)) < 0.05 ? 0 : 1);
}

QString withSigma(double points, double sigma)
{
    const QString text = pointsText(points);
    return sigma < 0.05 ? text : QStringLiteral("%1 ±%2").arg(text, pointsText(sigma));
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
        return Words::tr("%1: not measured, no points (%2)").arg(name, rule);
    const QString figure = metricFigure(*line.metric).text();
    if (line.criterion.points < 0)
        return Words::tr("%1 %2: %3 points (%4)").arg(name, figure, withSigma(line.points, line.sigma), rule);
    return Words::tr("%1 %2: %3 of %4 points (%5)")
        .arg(name, figure, withSigma(line.points, line.sigma), pointsText(line.criterion.points), rule);
}

} // namespace

BoundUnit boundUnit(const std::string &metric)
{
    struct Unit
    {
        const char *part, *unit;
        double factor;
    };
    static constexpr std::array<Unit, 10> units = {{{"path_completed", "%", 100},
                                                    {"cross_track", "mm", 1},
                                                    {"path_length", "m", 1},
                                                    {"turn_rate", "°/s", 180 / std::numbers::pi},
                                                    {"speed", "m/s", 1},
                                                    {"accel", "m/s²", 1},
                                                    {"time", "s", 1},
                                                    {"duration", "s", 1},
                                                    {"_lap", "s", 1},
                                                    {"radius", "m", 1}}};
    for (const Unit &each : units)
        if (metric.find(each.part) != std::string::npos)
            return {QString::fromUtf8(each.unit), each.factor};
    return {};
}

QString scoreText(const Score &score)
{
    return Words::tr("%1 of %2").arg(withSigma(score.points, score.sigma), pointsText(score.most));
}

QString criterionText(const Criterion &criterion)
{
    const QString full = boundText(criterion.metric, criterion.fullAt), none = boundText(criterion.metric, criterion.noneAt);
    const QString points = pointsText(std::abs(criterion.points));
    const bool less = criterion.fullAt < criterion.noneAt;
    if (criterion.points < 0)
        return less ? Words::tr("%1 points off at %2 or less, none off at %3 or more").arg(points, full, none)
                    : Words::tr("%1 points off at %2 or more, none off at %3 or less").arg(points, full, none);
    return less ? Words::tr("%1 points at %2 or less, none at %3 or more").arg(points, full, none)
                : Words::tr("%1 points at %2 or more, none at %3 or less").arg(points, full, none);
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
    std::ranges::copy(scoringMetrics(analysis->profile.spikes, analysis->profile.passages), std::back_inserter(metrics));
    return scoreOf(scene.scoring, metrics);
}

} // namespace odo
