// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/trial_model.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"

#include <QCollator>
#include <QDateTime>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace odo {

namespace {

TrialFilter::ListSection positionOf(const TrialRecord &trial, const TrialFilter &filter)
{
    if (trial.binned)
        return TrialFilter::ListSection::Bin;
    const bool isOfArchived = filter.className.empty() && filter.archivedClasses.contains(trial.className);
    return trial.archived || isOfArchived ? TrialFilter::ListSection::Archived
                                          : TrialFilter::ListSection::Active;
}

} // namespace

QString searchTextOf(const TrialRecord &trial)
{
    // A line break keeps a search word from matching across two fields.
    std::string words = trial.name + '\n' + trial.teamName + '\n' + trial.teamPseudonym + '\n' +
                        trial.className + '\n' + trial.task + '\n' + trial.notes;
    for (const std::string &robot : trial.robotNames)
        words += '\n' + robot;
    for (const std::string &tag : trial.tags)
        words += '\n' + tag;
    for (const auto &[name, value] : trial.variables)
        words += '\n' + name + ' ' + value;
    const QDateTime date = QDateTime::fromMSecsSinceEpoch(trial.date.time_since_epoch().count());
    return (QString::fromStdString(words) + u'\n' + QLocale().toString(date, QLocale::ShortFormat)).toLower();
}

bool isShown(const TrialFilter &filter, const QStringList &words, const TrialRecord &trial,
             const QString &searchText)
{
    if (positionOf(trial, filter) != filter.listSection || (filter.starred && !trial.starred))
        return false;
    if ((!filter.className.empty() && trial.className != filter.className) ||
        (!filter.team.empty() && trial.teamName != filter.team) ||
        (!filter.task.empty() && trial.task != filter.task))
        return false;
    if (!filter.robot.empty() && std::ranges::find(trial.robotNames, filter.robot) == trial.robotNames.end())
        return false;
    if ((filter.from && trial.date < *filter.from) || (filter.to && trial.date >= *filter.to))
        return false;
    return std::ranges::all_of(words, [&](const QString &word) { return searchText.contains(word); });
}

namespace {

const std::string shownMetric = "max_speed";

/// Numbers before texts, and both before those that have none.
std::tuple<int, double, QString> variableKey(const QString &value)
{
    enum Rank { Number, Text, None };
    bool isNumber = false;
    const double number = QLocale::c().toDouble(value, &isNumber);
    return {isNumber          ? Number
            : value.isEmpty() ? None
                              : Text,
            isNumber ? number : 0, withNumbersPadded(value.toLower())};
}

/// Of each trial whose task is scored that of its best robot, if any has one.
Result<std::unordered_map<RecordId, std::optional<Score>>> bestScores(Project &project, Instant from,
                                                                      Instant to)
{
    auto scores = ODO_TRY(trialScores(project, from, to));
    std::unordered_map<RecordId, std::optional<Score>> best;
    for (TrialScore &run : scores) {
        const auto listSection = best.try_emplace(run.trial).first;
        if (run.score && (!listSection->second || run.score->points > listSection->second->points))
            listSection->second = std::move(run.score);
    }
    return best;
}

/// The rows of trials, newest first, with their metrics.
Result<std::vector<TrialRow>> withMetrics(Project &project, std::vector<TrialRecord> trials)
{
    std::vector<TrialRow> rows;
    if (trials.empty())
        return rows;
    const auto trialMetrics =
        ODO_TRY(project.analyses().trialMetrics(shownMetric, trials.back().date, trials.front().date));
    std::unordered_map<RecordId, Metric> best;
    for (const TrialMetric &trialMetric : trialMetrics) {
        const auto [listSection, isNew] = best.try_emplace(trialMetric.trial, trialMetric.metric);
        if (!isNew && trialMetric.metric.value > listSection->second.value)
            listSection->second = trialMetric.metric;
    }
    auto scores = ODO_TRY(bestScores(project, trials.back().date, trials.front().date));
    const auto verdicts = ODO_TRY(project.verdicts().all(trials.back().date, trials.front().date));
    const auto missing = ODO_TRY(project.verdicts().missing(trials.back().date, trials.front().date));
    const std::unordered_set<RecordId> unchecked(missing.begin(), missing.end());
    rows.reserve(trials.size());
    for (TrialRecord &trial : trials) {
        const auto trialMetric = best.find(trial.id);
        QString searchText = searchTextOf(trial);
        rows.push_back({std::move(trial),
                        trialMetric == best.end() ? std::nullopt : std::optional(trialMetric->second),
                        std::move(searchText)});
        if (const auto score = scores.find(rows.back().trial.id); score != scores.end()) {
            rows.back().isScored = true;
            rows.back().score = std::move(score->second);
        }
        if (const auto verdict = verdicts.find(rows.back().trial.id); verdict != verdicts.end())
            rows.back().verdict = verdict->second;
        rows.back().isUnchecked = unchecked.contains(rows.back().trial.id);
    }
    return rows;
}

} // namespace

Result<std::vector<TrialRow>> TrialRows::next(int count)
{
    auto trials = ODO_TRY(m_project->trials().page(m_last ? &*m_last : nullptr, count));
    if (!trials.empty())
        m_last = trials.back();
    return withMetrics(*m_project, std::move(trials));
}

Result<TrialRow> loadTrialRow(Project &project, RecordId trial)
{
    auto record = ODO_TRY(project.trials().get(trial));
    auto rows = ODO_TRY(withMetrics(project, {std::move(record)}));
    return std::move(rows.front());
}

TrialModel::TrialModel(QObject *parent) : QAbstractTableModel(parent) {}

void TrialModel::setRows(std::vector<TrialRow> rows)
{
    std::set<std::string> variables;
    for (const TrialRow &row : rows)
        for (const auto &variable : row.trial.variables)
            variables.insert(variable.first);
    beginResetModel();
    m_rows = std::move(rows);
    m_variables.clear();
    for (const std::string &variable : variables)
        m_variables << QString::fromStdString(variable);
    choose();
    endResetModel();
}

void TrialModel::setFilter(TrialFilter filter)
{
    beginResetModel();
    m_filter = std::move(filter);
    choose();
    endResetModel();
}

void TrialModel::updateTeams()
{
    beginResetModel();
    choose();
    endResetModel();
}

void TrialModel::updateRow(TrialRow row)
{
    const auto known =
        std::ranges::find(m_rows, row.trial.id, [](const TrialRow &each) { return each.trial.id; });
    if (known == m_rows.end())
        return;
    addVariables(row);
    const TrialRow before = std::exchange(*known, std::move(row));
    const auto shown = std::ranges::find(m_shown, static_cast<std::size_t>(known - m_rows.begin()));
    if (shown == m_shown.end())
        return;
    const int listSection = static_cast<int>(shown - m_shown.begin());
    const QStringList words = m_filter.text.toLower().split(u' ', Qt::SkipEmptyParts);
    if (passes(*known, words)) {
        showChanged(listSection, before);
        return;
    }
    beginRemoveRows({}, listSection, listSection);
    m_shown.erase(shown);
    endRemoveRows();
}

void TrialModel::addVariables(const TrialRow &row)
{
    QStringList added;
    for (const auto &variable : row.trial.variables)
        if (const QString name = QString::fromStdString(variable.first); !m_variables.contains(name))
            added << name;
    if (added.isEmpty())
        return;
    const int first = columnCount();
    beginInsertColumns({}, first, first + static_cast<int>(added.size()) - 1);
    m_variables += added;
    endInsertColumns();
}

/// What is being written into a cell is overwritten when that changes: cells that can be written into are
/// named only if they hold something else now.
void TrialModel::showChanged(int row, const TrialRow &before)
{
    const TrialRow &now = this->row(row);
    for (int first = 0; first < columnCount();) {
        int end = first;
        const auto isChanged = [&](int column) {
            return editedValue(now, column) != editedValue(before, column) || !isEditable(now, column) ||
                   !isEditable(before, column);
        };
        while (end < columnCount() && isChanged(end))
            ++end;
        if (end > first)
            Q_EMIT dataChanged(index(row, first), index(row, end - 1));
        first = end + 1;
    }
}

void TrialModel::updateVerdict(const StoredVerdict &verdict)
{
    const auto known =
        std::ranges::find(m_rows, verdict.trial, [](const TrialRow &each) { return each.trial.id; });
    if (known == m_rows.end())
        return;
    TrialRow row = *known;
    row.verdict = verdict.verdict;
    row.isUnchecked = false;
    if (row.topSpeed)
        row.topSpeed->isAtLeast = std::ranges::any_of(verdict.lowerBounds, [](const auto &bounds) {
            return std::ranges::find(bounds.second, shownMetric) != bounds.second.end();
        });
    updateRow(std::move(row));
}

std::vector<RecordId> TrialModel::unchecked() const
{
    std::vector<RecordId> trials;
    for (const TrialRow &row : m_rows)
        if (row.isUnchecked)
            trials.push_back(row.trial.id);
    return trials;
}

bool TrialModel::passes(const TrialRow &row, const QStringList &words) const
{
    const bool isDoubtful = row.verdict && row.verdict->level() != CheckLevel::Pass;
    return (isDoubtful || !m_filter.doubtful) && isShown(m_filter, words, row.trial, row.searchText);
}

int TrialModel::indexOf(const QString &trial) const
{
    const std::string name = trial.toStdString();
    const auto found =
        std::ranges::find_if(m_shown, [&](std::size_t each) { return m_rows[each].trial.name == name; });
    return found == m_shown.end() ? -1 : static_cast<int>(found - m_shown.begin());
}

void TrialModel::choose()
{
    m_shown.clear();
    const QStringList words = m_filter.text.toLower().split(u' ', Qt::SkipEmptyParts);
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        if (passes(m_rows[i], words))
            m_shown.push_back(i);
    arrange();
}

void TrialModel::sort(int column, Qt::SortOrder order)
{
    if (column < 0 || column >= columnCount())
        return;
    Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);
    const std::vector<std::size_t> before = m_shown;
    m_sortColumn = column;
    m_sortOrder = order;
    arrange();
    std::vector<int> positionOf(m_rows.size(), -1);
    for (std::size_t i = 0; i < m_shown.size(); ++i)
        positionOf[m_shown[i]] = static_cast<int>(i);
    const QModelIndexList old = persistentIndexList();
    for (const QModelIndex &each : old)
        changePersistentIndex(each,
                              index(positionOf[before[static_cast<std::size_t>(each.row())]], each.column()));
    Q_EMIT layoutChanged({}, VerticalSortHint);
}

void TrialModel::arrange()
{
    const auto sortBy = [this](const auto &key) {
        if (m_sortOrder == Qt::AscendingOrder)
            std::ranges::stable_sort(m_shown, std::ranges::less(), key);
        else
            std::ranges::stable_sort(m_shown, std::ranges::greater(), key);
    };
    switch (m_sortColumn) {
    case DateColumn:
        return sortBy([this](std::size_t i) { return m_rows[i].trial.date; });
    case DurationColumn:
        return sortBy([this](std::size_t i) { return m_rows[i].trial.durationS; });
    case TopSpeedColumn: // trials without a value are grouped at one end
        return sortBy(
            [this](std::size_t i) { return m_rows[i].topSpeed ? m_rows[i].topSpeed->value : -1.0; });
    case ScoreColumn:
        return sortBy([this](std::size_t i) { return m_rows[i].score ? m_rows[i].score->points : -1e9; });
    case StarColumn:
        return sortBy([this](std::size_t i) { return m_rows[i].trial.starred; });
    case VerdictColumn: // the worst are grouped at one end
        return sortBy([this](std::size_t i) {
            const auto &verdict = m_rows[i].verdict;
            return !verdict ? -1 : 2 * int(verdict->level()) - int(verdict->isAccepted());
        });
    default:
        break;
    }
    if (m_sortColumn >= ColumnCount)
        return sortBy([this](std::size_t i) { return variableKey(display(m_rows[i], m_sortColumn)); });
    QCollator collator; // keys are made once a row, not once a comparison
    std::unordered_map<std::size_t, QCollatorSortKey> keys;
    for (const std::size_t i : m_shown)
        keys.emplace(i, collator.sortKey(withNumbersPadded(display(m_rows[i], m_sortColumn).toLower())));
    const bool rising = m_sortOrder == Qt::AscendingOrder;
    std::ranges::stable_sort(m_shown, [&](std::size_t a, std::size_t b) {
        const int order = keys.at(a).compare(keys.at(b));
        return rising ? order < 0 : order > 0;
    });
}

int TrialModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

int TrialModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount + static_cast<int>(m_variables.size());
}

} // namespace odo
