// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <QAbstractTableModel>
#include <vector>

namespace odo {

class Project;

/// A trial in the list, with the metrics of its best robot.
struct TrialRow
{
    TrialRecord trial;
    std::vector<AnalysisRecord> analyses; ///< metrics alone, one a robot; empty: not tracked
};

/// Reads all trials with their metrics, newest first. On the project's thread.
Result<std::vector<TrialRow>> loadTrialRows(Project &project);

/// The trials of a project: what History and the choice of a trial show.
class TrialModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Columns {
        NameColumn,
        TeamColumn,
        ClassColumn,
        TaskColumn,
        DateColumn,
        RobotsColumn,
        DurationColumn,
        TopSpeedColumn,
        ColumnCount
    };
    enum Roles {
        SortRole = Qt::UserRole, ///< of each column: text, date, or number
        NameRole,                ///< QString, of the row's trial
        NotesRole,               ///< QString
        SearchRole,              ///< QString: all that a person would look for, for a filter
    };

    explicit TrialModel(QObject *parent = nullptr);
    void setRows(std::vector<TrialRow> rows);
    const TrialRow &row(int index) const { return m_rows.at(static_cast<std::size_t>(index)); }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString display(const TrialRow &row, int column) const;
    QVariant sortKey(const TrialRow &row, int column) const;

    std::vector<TrialRow> m_rows;
};

} // namespace odo
