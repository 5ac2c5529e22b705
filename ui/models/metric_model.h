// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"
#include "ui/models/row_table_model.h"

#include <vector>

namespace odo {

/// The metrics of one robot's analysis, in words.
class MetricModel : public RowTableModel
{
    Q_OBJECT
public:
    enum Columns { NameColumn, ValueColumn, ColumnCount };
    enum Roles {
        IdRole = Qt::UserRole, ///< QString, Metric::name
        NumberRole,            ///< double
        ValueTextRole,         ///< QString, "1.83"
        SmallPrintRole,        ///< QString, "m/s ±0.02"
    };

    explicit MetricModel(QObject *parent = nullptr);
    void setMetrics(std::vector<Metric> metrics);

private:
    int rows() const override { return static_cast<int>(m_metrics.size()); }
    QVariant cell(int index, int column, int role) const override;
    QVariant heading(int column, int role) const override;
    std::vector<Metric> m_metrics;
};

} // namespace odo
