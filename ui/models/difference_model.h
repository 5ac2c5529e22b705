// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/metric_differences.h"
#include "core/trajectory/sector_times.h"

#include <QAbstractTableModel>
#include <vector>

namespace odo {

/// Figures of two runs side by side with their difference: a row a figure or a sector. What is within the
/// error is muted, and says so in words.
class DifferenceModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Columns { NameColumn, FirstColumn, SecondColumn, DifferenceColumn, ColumnCount };
    enum Roles {
        SignificantRole = Qt::UserRole, ///< bool; false also where there is nothing to compare
    };

    explicit DifferenceModel(QObject *parent = nullptr);
    void setMetrics(const std::vector<MetricDifference> &metrics);
    /// Of a run against the first one.
    void setSectors(const std::vector<SectorTimes> &sectors, std::size_t run);
    /// Above the columns of the two runs.
    void setRunNames(const QString &first, const QString &second);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Row
    {
        QString name, first, second, difference;
        bool isCompared = false, isSignificant = false;
    };
    void setRows(std::vector<Row> rows);

    std::vector<Row> m_rows;
    QString m_first, m_second;
};

} // namespace odo
