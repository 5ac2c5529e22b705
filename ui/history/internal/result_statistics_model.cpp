// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/result_statistics_model.h"

#include "ui/history/internal/results_model.h"
#include "ui/history/internal/tabbed_text.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_names.h"

#include <QLocale>
#include <algorithm>
#include <utility>

namespace odo {

namespace {

QVariant sideOf(int column)
{
    return QVariant::fromValue(
        (column >= ResultStatisticsModel::RunsColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

} // namespace

void ResultStatisticsModel::setStatistics(std::vector<ResultStatistics> statistics,
                                          std::vector<TrialTableColumn> columns, bool isByTeam)
{
    beginResetModel();
    m_statistics = std::move(statistics);
    m_columns = std::move(columns);
    m_isByTeam = isByTeam;
    order();
    endResetModel();
}

QString ResultStatisticsModel::groupName(const ResultStatistics &statistics) const
{
    if (statistics.group.empty())
        return QStringLiteral("–");
    return m_isByTeam ? shownTeam(statistics.group) : QString::fromStdString(statistics.group);
}

std::optional<double> ResultStatisticsModel::number(const ResultStatistics &statistics, int column) const
{
    switch (column) {
    case RunsColumn:
        return static_cast<double>(statistics.count);
    case MeanColumn:
        return statistics.mean;
    case MedianColumn:
        return statistics.median;
    case DeviationColumn:
        return statistics.deviation;
    case VariationColumn:
        return statistics.variation;
    case LeastColumn:
        return statistics.least;
    case MostColumn:
        return statistics.most;
    default:
        return std::nullopt;
    }
}

void ResultStatisticsModel::order()
{
    const bool isDown = m_sortOrder == Qt::DescendingOrder;
    if (m_sortColumn < 0)
        return;
    std::ranges::stable_sort(m_statistics, [&](const ResultStatistics &a, const ResultStatistics &b) {
        if (m_sortColumn == MetricColumn)
            return isDown ? b.column < a.column : a.column < b.column;
        if (m_sortColumn == GroupColumn) {
            const int order = QString::localeAwareCompare(groupName(a), groupName(b));
            return isDown ? order > 0 : order < 0;
        }
        const auto left = number(a, m_sortColumn), right = number(b, m_sortColumn);
        if (left && right)
            return isDown ? *right < *left : *left < *right;
        return left.has_value() && !right.has_value();
    });
}

void ResultStatisticsModel::sort(int column, Qt::SortOrder order)
{
    Q_EMIT layoutAboutToBeChanged();
    m_sortColumn = column;
    m_sortOrder = order;
    this->order();
    Q_EMIT layoutChanged();
}

int ResultStatisticsModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_statistics.size());
}

int ResultStatisticsModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ResultStatisticsModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const int column = index.column();
    if (role == Qt::TextAlignmentRole)
        return sideOf(column);
    if (role == Qt::ToolTipRole && column <= GroupColumn)
        return data(index, Qt::DisplayRole).toString().toHtmlEscaped();
    if (role != Qt::DisplayRole)
        return {};
    const ResultStatistics &statistics = m_statistics[static_cast<std::size_t>(index.row())];
    const TrialTableColumn &of = m_columns[statistics.column];
    switch (column) {
    case MetricColumn:
        return metricHeading(of);
    case GroupColumn:
        return groupName(statistics);
    case RunsColumn:
        return QLocale().toString(static_cast<qulonglong>(statistics.count));
    case MeanColumn: {
        const bool isKnown = statistics.meanSigma && *statistics.meanSigma > 0;
        const NumberText text = metricNumber(
            {of.metric, of.unit, statistics.mean, isKnown ? statistics.meanSigma : std::nullopt});
        return text.sigma.isEmpty() ? text.value : QStringLiteral("%1 ±%2").arg(text.value, text.sigma);
    }
    case VariationColumn:
        return statistics.variation ? QLocale().toString(100 * *statistics.variation, 'f', 1) : QString();
    default: {
        const auto value = number(statistics, column);
        return value ? metricNumber({of.metric, of.unit, *value, {}}).value : QString();
    }
    }
}

QString ResultStatisticsModel::heading(int column)
{
    switch (column) {
    case MetricColumn:
        return tr("Metric");
    case GroupColumn:
        return tr("Group");
    case RunsColumn:
        return tr("Runs");
    case MeanColumn:
        return tr("Mean");
    case MedianColumn:
        return tr("Median");
    case DeviationColumn:
        return tr("SD");
    case VariationColumn:
        return tr("CV %");
    case LeastColumn:
        return tr("Least");
    default:
        return tr("Most");
    }
}

QVariant ResultStatisticsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return sideOf(section);
    if (role == Qt::DisplayRole)
        return heading(section);
    if (role != Qt::ToolTipRole)
        return {};
    switch (section) {
    case RunsColumn:
        return tr("Number of values: runs without bad results, lower bounds or another course");
    case MeanColumn:
        return tr("Mean ± its standard error (SD / √runs)");
    case DeviationColumn:
        return tr("Standard deviation of one run");
    case VariationColumn:
        return tr("Coefficient of variation: SD as a part of the mean");
    default:
        return {};
    }
}

QString ResultStatisticsModel::tabbed(const std::vector<int> &rows) const
{
    QStringList cells;
    for (int column = 0; column < ColumnCount; ++column) {
        cells << heading(column);
        if (column == MeanColumn)
            cells << QStringLiteral("± ") + cells.back();
    }
    QString text = asLine(cells);
    for (const int row : rows) {
        const ResultStatistics &statistics = m_statistics[static_cast<std::size_t>(row)];
        const double factor = factorOf(m_columns[statistics.column]);
        cells = {plainCell(metricHeading(m_columns[statistics.column])), plainCell(groupName(statistics))};
        for (int column = RunsColumn; column < ColumnCount; ++column) {
            auto value = number(statistics, column);
            if (value && column != RunsColumn)
                *value *= column == VariationColumn ? 100 : factor;
            cells << plainNumber(value);
            if (column == MeanColumn)
                cells << plainNumber(statistics.meanSigma ? std::optional(*statistics.meanSigma * factor)
                                                          : std::nullopt);
        }
        text += asLine(cells);
    }
    return text;
}

} // namespace odo
