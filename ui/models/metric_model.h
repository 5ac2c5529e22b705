// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <QAbstractTableModel>
#include <vector>

namespace odo {

/// The metrics of one robot's analysis, in words.
class MetricModel : public QAbstractTableModel
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

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<Metric> m_metrics;
};

} // namespace odo
