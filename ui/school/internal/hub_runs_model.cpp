// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/school/internal/hub_runs_model.h"

#include "ui/models/number_text.h"

#include <QLocale>
#include <utility>

namespace odo {

void HubRunsModel::setRuns(std::vector<HubRun> runs, bool isAll)
{
    beginResetModel();
    m_runs = std::move(runs);
    m_isAll = isAll;
    endResetModel();
}

void HubRunsModel::addRuns(const std::vector<HubRun> &runs, bool isAll)
{
    m_isAll = isAll;
    if (runs.empty())
        return;
    const auto first = static_cast<int>(m_runs.size());
    beginInsertRows({}, first, first + static_cast<int>(runs.size()) - 1);
    m_runs.insert(m_runs.end(), runs.begin(), runs.end());
    endInsertRows();
}

int HubRunsModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_runs.size());
}

int HubRunsModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant HubRunsModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::ToolTipRole))
        return {};
    const HubRun &run = m_runs[static_cast<std::size_t>(index.row())];
    const auto text = [role](const std::string &words) {
        const QString shown = QString::fromStdString(words);
        return role == Qt::ToolTipRole ? shown.toHtmlEscaped() : shown;
    };
    switch (index.column()) {
    case DateColumn:
        return shortDate(run.held);
    case TrialColumn:
        return text(run.name);
    case BenchColumn:
        return text(run.bench);
    case TeamColumn:
        return text(run.team);
    case ClassColumn:
        return text(run.className);
    case RobotColumn:
        return text(run.robot);
    case TaskColumn:
        return text(run.task);
    case DurationColumn:
        return tr("%1 s").arg(QLocale().toString(run.durationS, 'f', 1));
    case StandingColumn:
        if (run.standing == "pass")
            return tr("counts");
        if (run.standing == "doubtful")
            return tr("doubtful");
        if (run.standing == "bad")
            return tr("does not count");
        return tr("another course");
    default:
        return {};
    }
}

QVariant HubRunsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case DateColumn:
        return tr("Date");
    case TrialColumn:
        return tr("Trial");
    case BenchColumn:
        return tr("Bench");
    case TeamColumn:
        return tr("Team");
    case ClassColumn:
        return tr("Class");
    case RobotColumn:
        return tr("Robot");
    case TaskColumn:
        return tr("Task");
    case DurationColumn:
        return tr("Duration");
    case StandingColumn:
        return tr("Standings");
    default:
        return {};
    }
}

} // namespace odo
