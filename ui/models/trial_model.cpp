// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/trial_model.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/models/figure_text.h"

#include <QDateTime>
#include <QLocale>
#include <QStringList>

namespace odo {

namespace {

QDateTime localDate(Instant instant)
{
    return QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count());
}

QString robotNames(const TrialRecord &trial)
{
    QStringList names;
    for (const std::string &name : trial.robotNames)
        names += QString::fromStdString(name);
    return names.join(QStringLiteral(", "));
}

const Metric *topSpeed(const TrialRow &row)
{
    const Metric *best = nullptr;
    for (const AnalysisRecord &analysis : row.analyses) {
        for (const Metric &metric : analysis.profile.metrics) {
            if (metric.name == "max_speed" && (!best || metric.value > best->value))
                best = &metric;
        }
    }
    return best;
}

} // namespace

Result<std::vector<TrialRow>> loadTrialRows(Project &project)
{
    auto trials = project.trials().all();
    if (!trials)
        return tl::make_unexpected(trials.error());
    std::vector<TrialRow> rows;
    rows.reserve(trials->size());
    for (TrialRecord &trial : *trials) {
        auto metrics = project.analyses().currentMetrics(trial.id);
        if (!metrics)
            return tl::make_unexpected(metrics.error());
        rows.push_back({std::move(trial), std::move(*metrics)});
    }
    return rows;
}

TrialModel::TrialModel(QObject *parent) : QAbstractTableModel(parent) {}

void TrialModel::setRows(std::vector<TrialRow> rows)
{
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

int TrialModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int TrialModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString TrialModel::display(const TrialRow &row, int column) const
{
    switch (column) {
    case NameColumn:
        return QString::fromStdString(row.trial.name);
    case TeamColumn:
        return QString::fromStdString(row.trial.teamName);
    case ClassColumn:
        return QString::fromStdString(row.trial.className);
    case TaskColumn:
        return QString::fromStdString(row.trial.task);
    case DateColumn:
        return QLocale().toString(localDate(row.trial.date), QLocale::ShortFormat);
    case RobotsColumn:
        return robotNames(row.trial);
    case DurationColumn:
        return secondsText(fromSeconds(row.trial.durationS));
    case TopSpeedColumn: {
        const Metric *metric = topSpeed(row);
        return metric ? metricFigure(*metric).text() : tr("not tracked");
    }
    default:
        return {};
    }
}

QVariant TrialModel::sortKey(const TrialRow &row, int column) const
{
    switch (column) {
    case DateColumn:
        return localDate(row.trial.date);
    case DurationColumn:
        return row.trial.durationS;
    case TopSpeedColumn: {
        const Metric *metric = topSpeed(row);
        return metric ? metric->value : -1.0; // trials without a figure come together at one end
    }
    default:
        return display(row, column);
    }
}

QVariant TrialModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const TrialRow &row = m_rows[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole:
        return display(row, column);
    case Qt::TextAlignmentRole: {
        const bool number = column == DurationColumn || column == TopSpeedColumn;
        return QVariant::fromValue(
            Qt::Alignment(Qt::AlignVCenter | (number ? Qt::AlignRight : Qt::AlignLeft)));
    }
    case SortRole:
        return sortKey(row, column);
    case NameRole:
        return display(row, NameColumn);
    case NotesRole:
        return QString::fromStdString(row.trial.notes);
    case SearchRole: {
        QStringList words;
        for (const int each : {NameColumn, TeamColumn, ClassColumn, TaskColumn, DateColumn, RobotsColumn})
            words += display(row, each);
        words += QString::fromStdString(row.trial.notes);
        return words.join(u' ');
    }
    default:
        return {};
    }
}

QVariant TrialModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case NameColumn:
        return tr("Trial");
    case TeamColumn:
        return tr("Team");
    case ClassColumn:
        return tr("Class");
    case TaskColumn:
        return tr("Task");
    case DateColumn:
        return tr("Date");
    case RobotsColumn:
        return tr("Robots");
    case DurationColumn:
        return tr("Time");
    case TopSpeedColumn:
        return tr("Top speed");
    default:
        return {};
    }
}

} // namespace odo
