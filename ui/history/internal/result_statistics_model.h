// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/result_statistics.h"

#include <QAbstractTableModel>
#include <QString>
#include <optional>
#include <vector>

namespace odo {

/// Statistics of groups of runs, a row for each metric and group. GUI thread.
class ResultStatisticsModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Columns {
        MetricColumn,
        GroupColumn,
        RunsColumn,
        MeanColumn,
        MedianColumn,
        DeviationColumn,
        VariationColumn,
        LeastColumn,
        MostColumn,
        ColumnCount
    };

    using QAbstractTableModel::QAbstractTableModel;
    /// columns: of the table that they are of. isByTeam: groups are teams, which may be shown otherwise.
    void setStatistics(std::vector<ResultStatistics> statistics, std::vector<TrialTableColumn> columns,
                       bool isByTeam);
    const std::vector<ResultStatistics> &statistics() const { return m_statistics; }
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;
    /// As ResultsModel's.
    QString tabbed(const std::vector<int> &rows) const;

private:
    static QString heading(int column);
    QString groupName(const ResultStatistics &statistics) const;
    std::optional<double> number(const ResultStatistics &statistics, int column) const;
    void order();

    std::vector<ResultStatistics> m_statistics;
    std::vector<TrialTableColumn> m_columns;
    bool m_isByTeam = false;
    int m_sortColumn = -1; ///< as they came
    Qt::SortOrder m_sortOrder = Qt::AscendingOrder;
};

} // namespace odo
