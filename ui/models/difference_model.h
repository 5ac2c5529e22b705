// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/metric_differences.h"
#include "core/trajectory/sector_times.h"
#include "ui/models/row_table_model.h"

#include <vector>

namespace odo {

/// Figures of two runs side by side with their difference: a row a figure or a sector. What is within the
/// error is muted, and says so in words.
class DifferenceModel : public RowTableModel
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

private:
    int rows() const override { return static_cast<int>(m_rows.size()); }
    QVariant cell(int index, int column, int role) const override;
    QVariant heading(int column, int role) const override;
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
