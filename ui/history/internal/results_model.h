// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/result_statistics.h"

#include <QAbstractTableModel>
#include <QStringList>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// Which runs of a table are shown. What is empty excludes none.
struct ResultsFilter
{
    std::string className, task;
    QString text; ///< each of its words is in the trial, team, class, task, robot, tags or variables
};

/// Trials × metrics: a row for each robot of each trial, filtered and sorted; each metric with its σ in the
/// unit that is shown. GUI thread.
class ResultsModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Columns {
        TrialColumn,
        TeamColumn,
        ClassColumn,
        TaskColumn,
        RobotColumn,
        DateColumn,
        VerdictColumn,
        FactCount
    };
    enum Roles {
        BadgeTextRole = Qt::UserRole, ///< QString
        BadgeStateRole,               ///< int, BadgeState
    };

    explicit ResultsModel(QObject *parent = nullptr);
    void setTable(std::shared_ptr<const ResultTable> table);
    const std::shared_ptr<const ResultTable> &table() const { return m_table; }
    /// Columns of the table, in their order.
    void setMetrics(std::vector<std::size_t> columns);
    const std::vector<std::size_t> &metrics() const { return m_metrics; }
    void setFilter(ResultsFilter filter);
    /// Of the table, as they are shown.
    const std::vector<std::size_t> &shownRows() const { return m_rows; }
    /// All shown rows have the same in a column of words, or there is none.
    bool isAlike(int column) const;
    /// Empty: no such row.
    QString trialAt(int row) const;
    /// Those runs and metrics as a table of its own, in the order on screen; teams by their shown names.
    ResultTable shownTable() const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;
    /// Such rows with the headings for a spreadsheet: cells parted by tabs, value and σ apart, all digits.
    QString tabbed(const std::vector<int> &rows) const;

private:
    bool isShown(std::size_t row) const;
    void choose();
    void order();
    QString fact(std::size_t row, int column) const;
    const std::optional<Metric> &metric(std::size_t row, int column) const;
    const TrialTableColumn &metricColumn(int column) const;
    bool isVariable(int column) const;

    std::shared_ptr<const ResultTable> m_table;
    std::vector<QString> m_words; ///< of each row, what the filter's text is searched in
    std::vector<std::size_t> m_rows, m_metrics;
    ResultsFilter m_filter;
    int m_sortColumn = DateColumn;
    Qt::SortOrder m_sortOrder = Qt::DescendingOrder;
};

/// "Top speed (m/s)", in the unit that is shown.
QString metricHeading(const TrialTableColumn &column);

} // namespace odo
