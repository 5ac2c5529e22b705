// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/metric_model.h"

#include "ui/models/figure_text.h"

namespace odo {

MetricModel::MetricModel(QObject *parent) : QAbstractTableModel(parent) {}

void MetricModel::setMetrics(std::vector<Metric> metrics)
{
    beginResetModel();
    m_metrics = std::move(metrics);
    endResetModel();
}

int MetricModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_metrics.size());
}

int MetricModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant MetricModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Metric &metric = m_metrics[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return index.column() == NameColumn ? metricName(metric.name) : metricFigure(metric).text();
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::Alignment(Qt::AlignLeft | Qt::AlignVCenter));
    case IdRole:
        return QString::fromStdString(metric.name);
    case NumberRole:
        return metric.value;
    case ValueTextRole:
        return metricFigure(metric).value;
    case SmallPrintRole:
        return metricFigure(metric).smallPrint();
    default:
        return {};
    }
}

QVariant MetricModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return section == NameColumn ? tr("Figure") : tr("Value");
}

} // namespace odo
