// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/results_model.h"

#include "core/base/units.h"
#include "ui/history/internal/tabbed_text.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_names.h"
#include "ui/models/verdict_mark.h"

#include <QCollator>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace odo {

QString metricHeading(const TrialTableColumn &column)
{
    const QString name = metricName(column.metric);
    const QString unit = metricUnit({column.metric, column.unit, 0, {}}).name;
    return unit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, unit);
}

ResultsModel::ResultsModel(QObject *parent)
    : QAbstractTableModel(parent), m_table(std::make_shared<ResultTable>())
{
}

void ResultsModel::setTable(std::shared_ptr<const ResultTable> table)
{
    beginResetModel();
    m_table = std::move(table);
    m_metrics.clear();
    m_words.clear();
    m_words.reserve(m_table->rows.size());
    for (const TrialTableRow &row : m_table->rows) {
        QStringList words{QString::fromStdString(row.trial.name), shownTeam(row.trial),
                          QString::fromStdString(row.trial.className), QString::fromStdString(row.trial.task),
                          QString::fromStdString(row.robot)};
        for (const std::string &tag : row.trial.tags)
            words << QString::fromStdString(tag);
        for (const auto &variable : row.trial.variables)
            words << QString::fromStdString(variable.second);
        m_words.push_back(words.join(u'\n'));
    }
    choose();
    endResetModel();
}

void ResultsModel::setMetrics(std::vector<std::size_t> columns)
{
    beginResetModel();
    m_metrics = std::move(columns);
    order();
    endResetModel();
}

void ResultsModel::setFilter(ResultsFilter filter)
{
    beginResetModel();
    m_filter = std::move(filter);
    choose();
    endResetModel();
}

bool ResultsModel::isShown(std::size_t row) const
{
    const TrialRecord &trial = m_table->rows[row].trial;
    if ((!m_filter.className.empty() && trial.className != m_filter.className) ||
        (!m_filter.task.empty() && trial.task != m_filter.task))
        return false;
    const auto words = QStringView(m_filter.text).split(u' ', Qt::SkipEmptyParts);
    return std::ranges::all_of(
        words, [&](QStringView word) { return m_words[row].contains(word, Qt::CaseInsensitive); });
}

void ResultsModel::choose()
{
    m_rows.clear();
    for (std::size_t row = 0; row < m_table->rows.size(); ++row)
        if (isShown(row))
            m_rows.push_back(row);
    order();
}

bool ResultsModel::isVariable(int column) const
{
    return column >= FactCount && column < FactCount + static_cast<int>(m_table->variables.size());
}

const TrialTableColumn &ResultsModel::metricColumn(int column) const
{
    return m_table
        ->columns[m_metrics[static_cast<std::size_t>(column) - FactCount - m_table->variables.size()]];
}

const std::optional<Metric> &ResultsModel::metric(std::size_t row, int column) const
{
    const std::size_t shown = static_cast<std::size_t>(column) - FactCount - m_table->variables.size();
    return m_table->rows[row].metrics[m_metrics[shown]];
}

QString ResultsModel::fact(std::size_t row, int column) const
{
    const TrialTableRow &run = m_table->rows[row];
    switch (column) {
    case TrialColumn:
        return QString::fromStdString(run.trial.name);
    case TeamColumn:
        return shownTeam(run.trial);
    case ClassColumn:
        return QString::fromStdString(run.trial.className);
    case TaskColumn:
        return QString::fromStdString(run.trial.task);
    case RobotColumn:
        return QString::fromStdString(run.robot);
    case DateColumn:
        return shortDate(run.trial.date);
    case VerdictColumn:
        return run.robot.empty() ? tr("not tracked") : run.verdict ? shownVerdict(*run.verdict) : QString();
    default:
        break;
    }
    const std::string &variable = m_table->variables[static_cast<std::size_t>(column) - FactCount];
    const auto found = run.trial.variables.find(variable);
    return found == run.trial.variables.end() ? QString() : QString::fromStdString(found->second);
}

bool ResultsModel::isAlike(int column) const
{
    return m_rows.empty() ||
           std::ranges::all_of(m_rows, [&, first = fact(m_rows.front(), column)](std::size_t row) {
               return fact(row, column) == first;
           });
}

/// Numbers by their size, words as a person sorts them ("Trial 2" before "Trial 10"); what is missing last.
void ResultsModel::order()
{
    const bool isDown = m_sortOrder == Qt::DescendingOrder;
    if (m_sortColumn >= columnCount())
        m_sortColumn = DateColumn;
    if (m_sortColumn == DateColumn) {
        std::ranges::stable_sort(m_rows, [&](std::size_t left, std::size_t right) {
            const Instant a = m_table->rows[left].trial.date, b = m_table->rows[right].trial.date;
            return isDown ? b < a : a < b;
        });
        return;
    }
    struct Key
    {
        std::optional<double> number;
        std::optional<QCollatorSortKey> words;
    };
    QCollator collator;
    std::vector<std::pair<Key, std::size_t>> keyed;
    keyed.reserve(m_rows.size());
    const bool isMetric = m_sortColumn >= FactCount && !isVariable(m_sortColumn);
    for (const std::size_t row : m_rows) {
        Key key;
        if (isMetric) {
            if (const auto &value = metric(row, m_sortColumn); value && std::isfinite(value->value))
                key.number = value->value;
        } else if (const QString words = fact(row, m_sortColumn); !words.isEmpty()) {
            if (isVariable(m_sortColumn))
                if (const auto number = parseNumber(words.toStdString()))
                    key.number = *number;
            key.words = collator.sortKey(withNumbersPadded(words.toLower()));
        }
        keyed.emplace_back(std::move(key), row);
    }
    std::ranges::stable_sort(keyed, [isDown](const auto &left, const auto &right) {
        const Key &a = left.first, &b = right.first;
        if (a.number && b.number)
            return isDown ? *b.number < *a.number : *a.number < *b.number;
        if (a.number.has_value() != b.number.has_value())
            return a.number.has_value();
        if (a.words && b.words)
            return isDown ? *b.words < *a.words : *a.words < *b.words;
        return a.words.has_value() && !b.words.has_value();
    });
    std::ranges::transform(keyed, m_rows.begin(), [](const auto &each) { return each.second; });
}

void ResultsModel::sort(int column, Qt::SortOrder order)
{
    Q_EMIT layoutAboutToBeChanged();
    m_sortColumn = std::max(0, column);
    m_sortOrder = order;
    this->order();
    Q_EMIT layoutChanged();
}

int ResultsModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ResultsModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : FactCount + static_cast<int>(m_table->variables.size() + m_metrics.size());
}

QVariant ResultsModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const std::size_t row = m_rows[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    if (column < FactCount || isVariable(column)) {
        const TrialTableRow &run = m_table->rows[row];
        const bool isBadge = column == VerdictColumn && run.verdict && !run.robot.empty();
        switch (role) {
        case Qt::DisplayRole:
            return fact(row, column);
        case Qt::ToolTipRole:
            return isBadge ? verdictText(*run.verdict).toHtmlEscaped() : fact(row, column).toHtmlEscaped();
        case BadgeTextRole:
            return isBadge ? verdictBadge(*run.verdict).text : QString();
        case BadgeStateRole:
            return isBadge ? static_cast<int>(verdictBadge(*run.verdict).state) : 0;
        default:
            return {};
        }
    }
    const std::optional<Metric> &value = metric(row, column);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    if (!value || (role != Qt::DisplayRole && role != Qt::ToolTipRole))
        return {};
    if (role == Qt::ToolTipRole)
        return isUsed(*m_table, row,
                      m_metrics[static_cast<std::size_t>(column) - FactCount - m_table->variables.size()])
                   ? QVariant()
                   : tr("Not used in means: a lower bound, a bad result, or another course");
    const NumberText text = metricNumber(*value);
    return text.sigma.isEmpty() ? text.value : QStringLiteral("%1 ±%2").arg(text.value, text.sigma);
}

QVariant ResultsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    const bool isMetric = section >= FactCount && !isVariable(section);
    if (role == Qt::TextAlignmentRole && isMetric)
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    if (isMetric)
        return metricHeading(metricColumn(section));
    if (isVariable(section))
        return QString::fromStdString(m_table->variables[static_cast<std::size_t>(section - FactCount)]);
    const std::array<QString, FactCount> words{tr("Trial"), tr("Team"), tr("Class"),  tr("Task"),
                                               tr("Robot"), tr("Date"), tr("Verdict")};
    return words[static_cast<std::size_t>(section)];
}

QString ResultsModel::trialAt(int row) const
{
    return row >= 0 && row < rowCount()
               ? QString::fromStdString(m_table->rows[m_rows[static_cast<std::size_t>(row)]].trial.name)
               : QString();
}

ResultTable ResultsModel::shownTable() const
{
    ResultTable shown;
    shown.variables = m_table->variables;
    for (const std::size_t column : m_metrics)
        shown.columns.push_back(m_table->columns[column]);
    for (const std::size_t from : m_rows) {
        TrialTableRow row = m_table->rows[from];
        row.trial.teamName = shownTeam(row.trial).toStdString();
        row.metrics.clear();
        for (const std::size_t column : m_metrics)
            row.metrics.push_back(m_table->rows[from].metrics[column]);
        shown.rows.push_back(std::move(row));
    }
    return shown;
}

QString ResultsModel::tabbed(const std::vector<int> &rows) const
{
    const int firstMetric = FactCount + static_cast<int>(m_table->variables.size());
    QStringList cells;
    for (int column = 0; column < columnCount(); ++column) {
        const QString title = plainCell(headerData(column, Qt::Horizontal).toString());
        cells << title;
        if (column >= firstMetric)
            cells << QStringLiteral("± ") + title;
    }
    QString text = asLine(cells);
    for (const int shown : rows) {
        const std::size_t row = m_rows[static_cast<std::size_t>(shown)];
        cells.clear();
        for (int column = 0; column < firstMetric; ++column)
            cells << plainCell(fact(row, column));
        for (int column = firstMetric; column < columnCount(); ++column) {
            const std::optional<Metric> &value = metric(row, column);
            const double factor = factorOf(metricColumn(column));
            cells << plainNumber(value ? std::optional(value->value * factor) : std::nullopt)
                  << plainNumber(value && value->sigma ? std::optional(*value->sigma * factor)
                                                       : std::nullopt);
        }
        text += asLine(cells);
    }
    return text;
}

} // namespace odo
