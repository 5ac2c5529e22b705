// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/standings_model.h"

#include "ui/models/figure_text.h"
#include "ui/models/shown_team.h"

#include <QLocale>

namespace odo {

namespace {

QString figure(const TeamStanding &team, double value, std::optional<double> sigma)
{
    Metric metric = team.runs.front().metric; // its name and unit
    metric.value = value;
    metric.sigma = sigma;
    return metricFigure(metric).text();
}

} // namespace

QString progressText(const TeamStanding &team, const Standings &standings)
{
    if (!standings.isRanked())
        return StandingsModel::tr("choose a task");
    if (!team.progress.change)
        return StandingsModel::tr("three trials at different times tell");
    const Figure change = *team.progress.change;
    const QString by = figure(team, change.value, change.sigma);
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
        return m_standings.isRanked() ? QLocale().toString(team.figures.rank) : QStringLiteral("–");
    case TeamColumn:
        return teamName(row);
    case ClassColumn:
        return QString::fromStdString(team.className);
    case RunsColumn:
        return QLocale().toString(team.progress.count);
    case BestColumn:
        return figure(team, team.progress.best, std::nullopt);
    case MedianColumn:
        return figure(team, team.figures.median,
                      team.figures.sigma > 0 ? std::optional(team.figures.sigma) : std::nullopt);
    case SpreadColumn:
        return team.progress.spread ? figure(team, *team.progress.spread, std::nullopt) : tr("one trial");
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
        return tip ? tr("One more than the teams that are better beyond doubt: their medians differ by more "
                        "than 1.96 σ. Runs of different tasks are not ranked")
                   : tr("Rank");
    case TeamColumn:
        return tr("Team");
    case ClassColumn:
        return tr("Class");
    case RunsColumn:
        return tr("Trials");
    case BestColumn:
        return tr("Best");
    case MedianColumn:
        return tip ? tr("± from the spread of all teams' trials") : tr("Median");
    case SpreadColumn:
        return tip ? tr("Repeatability: standard deviation of one trial about the line of progress")
                   : tr("Spread");
    case ProgressColumn:
        return tip ? tr("Change through the term by a straight line; beyond the spread by Student's test, 95 "
                        "%")
                   : tr("Progress");
    default:
        return {};
    }
}

} // namespace odo
