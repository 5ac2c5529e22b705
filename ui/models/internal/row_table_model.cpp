// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/internal/row_table_model.h"

#include "ui/models/number_text.h"

namespace odo {

QVariant RowTableModel::data(const QModelIndex &index, int role) const
{
    return checkIndex(index, CheckIndexOption::IndexIsValid) ? cell(index.row(), index.column(), role)
                                                             : QVariant();
}

QVariant RowTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const bool isThere = orientation == Qt::Horizontal && section >= 0 && section < m_columns;
    return isThere ? heading(section, role) : QVariant();
}

QVariant RowTableModel::aligned(Qt::Alignment side)
{
    return QVariant::fromValue(side | Qt::AlignVCenter);
}

MetricModel::MetricModel(QObject *parent) : RowTableModel(ColumnCount, parent) {}

void MetricModel::setMetrics(std::vector<Metric> metrics)
{
    beginResetModel();
    m_metrics = std::move(metrics);
    endResetModel();
}

QVariant MetricModel::cell(int index, int column, int role) const
{
    const Metric &metric = m_metrics[static_cast<std::size_t>(index)];
    switch (role) {
    case Qt::DisplayRole:
        return column == NameColumn ? metricName(metric.name) : metricNumber(metric).text();
    case Qt::TextAlignmentRole:
        return aligned(Qt::AlignLeft);
    case IdRole:
        return QString::fromStdString(metric.name);
    case NumberRole:
        return metric.value;
    case ValueTextRole:
        return metricNumber(metric).value;
    case SmallPrintRole:
        return metricNumber(metric).smallPrint();
    default:
        return {};
    }
}

QVariant MetricModel::heading(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    return column == NameColumn ? tr("Metric") : tr("Value");
}

} // namespace odo
