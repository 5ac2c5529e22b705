// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/difference_model.h"

#include "ui/models/figure_text.h"

#include <algorithm>

namespace odo {

namespace {

const QString dash = QStringLiteral("–");

/// "1.83 ±0.02", the unit stands beside the name.
QString bareText(FigureText figure)
{
    figure.unit.clear();
    return figure.text();
}

/// With a plus where it is one.
QString signedText(const FigureText &figure, double value)
{
    const bool hasDigits =
        std::ranges::any_of(figure.value, [](QChar c) { return c.isDigit() && c.digitValue() > 0; });
    return (value > 0 && hasDigits ? QStringLiteral("+") : QString()) + bareText(figure);
}

QString metricText(const MetricDifference &metric, const std::optional<double> &value,
                   const std::optional<double> &sigma)
{
    return value ? bareText(metricFigure({metric.name, metric.unit, *value, sigma})) : dash;
}

QString secondsFigure(const std::optional<Difference> &time)
{
    return time ? bareText(figureText(time->value, time->sigma, QString())) : dash;
}

} // namespace

DifferenceModel::DifferenceModel(QObject *parent) : RowTableModel(ColumnCount, parent) {}

void DifferenceModel::setMetrics(const std::vector<MetricDifference> &metrics)
{
    std::vector<Row> rows;
    for (const MetricDifference &metric : metrics) {
        const QString unit = metricFigure({metric.name, metric.unit, 0, std::nullopt}).unit;
        Row row{unit.isEmpty() ? metricName(metric.name) : tr("%1, %2").arg(metricName(metric.name), unit),
                metricText(metric, metric.a, metric.sigmaA),
                metricText(metric, metric.b, metric.sigmaB),
                dash,
                metric.difference.has_value(),
                false};
        if (metric.difference) {
            const Metric difference{metric.name, metric.unit, metric.difference->value,
                                    metric.difference->sigma};
            row.difference = signedText(metricFigure(difference), difference.value);
            row.isSignificant = metric.difference->isSignificant();
        }
        rows.push_back(std::move(row));
    }
    setRows(std::move(rows));
}

void DifferenceModel::setSectors(const std::vector<SectorTimes> &sectors, std::size_t run)
{
    std::vector<Row> rows;
    for (const SectorTimes &sector : sectors) {
        const QString from = sector.from.empty() ? tr("begin") : QString::fromStdString(sector.from);
        const QString to = sector.to.empty() ? tr("end") : QString::fromStdString(sector.to);
        const auto &difference = sector.differences[run];
        Row row{tr("%1 to %2").arg(from, to),     secondsFigure(sector.times[0]),
                secondsFigure(sector.times[run]), dash,
                difference.has_value(),           difference && difference->isSignificant()};
        if (difference)
            row.difference =
                signedText(figureText(difference->value, difference->sigma, QString()), difference->value);
        rows.push_back(std::move(row));
    }
    setRows(std::move(rows));
}

void DifferenceModel::setRows(std::vector<Row> rows)
{
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

void DifferenceModel::setRunNames(const QString &first, const QString &second)
{
    m_first = first;
    m_second = second;
    Q_EMIT headerDataChanged(Qt::Horizontal, FirstColumn, SecondColumn);
}

QVariant DifferenceModel::cell(int index, int column, int role) const
{
    const Row &row = m_rows[static_cast<std::size_t>(index)];
    switch (role) {
    case Qt::DisplayRole:
        return column == NameColumn    ? row.name
               : column == FirstColumn ? row.first
               : column == SecondColumn
                   ? row.second
                   : (row.isCompared && !row.isSignificant ? QStringLiteral("≈ ") : QString()) +
                         row.difference;
    case Qt::ToolTipRole:
        if (!row.isCompared)
            return tr("Only one of the two has it");
        return row.isSignificant
                   ? tr("%1: beyond the error (95 %)").arg(row.name)
                   : tr("%1: within the error (95 %), no difference can be claimed").arg(row.name);
    case Qt::AccessibleDescriptionRole:
        return !row.isCompared     ? QString()
               : row.isSignificant ? tr("beyond the error")
                                   : tr("within the error");
    case Qt::TextAlignmentRole:
        return aligned(column == NameColumn ? Qt::AlignLeft : Qt::AlignRight);
    case SignificantRole:
        return row.isSignificant;
    default:
        return {};
    }
}

QVariant DifferenceModel::heading(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return aligned(column == NameColumn ? Qt::AlignLeft : Qt::AlignRight);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case FirstColumn:
        return m_first;
    case SecondColumn:
        return m_second;
    case DifferenceColumn:
        return tr("Difference");
    default:
        return QString();
    }
}

} // namespace odo
