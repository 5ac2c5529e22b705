// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/hub_results.h"

#include <QAbstractTableModel>
#include <vector>

namespace odo {

/// The runs of a hub as a table that grows as it is scrolled. GUI thread.
class HubRunsModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Columns {
        DateColumn,
        TrialColumn,
        BenchColumn,
        TeamColumn,
        ClassColumn,
        RobotColumn,
        TaskColumn,
        DurationColumn,
        StandingColumn,
        ColumnCount
    };

    using QAbstractTableModel::QAbstractTableModel;
    /// isAll: there are no more behind them.
    void setRuns(std::vector<HubRun> runs, bool isAll);
    void addRuns(const std::vector<HubRun> &runs, bool isAll);
    const std::vector<HubRun> &runs() const { return m_runs; }
    bool isAll() const { return m_isAll; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    bool canFetchMore(const QModelIndex &parent) const override { return !parent.isValid() && !m_isAll; }
    void fetchMore(const QModelIndex &) override { Q_EMIT moreWanted(); }

Q_SIGNALS:
    void moreWanted(); ///< addRuns answers it

private:
    std::vector<HubRun> m_runs;
    bool m_isAll = true;
};

} // namespace odo
