// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/trial_model.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"
#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_names.h"
#include "ui/models/verdict_mark.h"

#include <QCollator>
#include <QDateTime>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <unordered_map>
#include <unordered_set>

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

QDateTime localDate(Instant instant)
{
    return QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count());
}

QString joined(const std::vector<std::string> &names)
{
    QStringList list;
    for (const std::string &name : names)
        list += QString::fromStdString(name);
    return list.join(QStringLiteral(", "));
}

/// As a text sorts by the numbers in it: "Trial 9" before "Trial 10". QCollator's own way needs a locale that
/// has one.
QString withNumbersPadded(const QString &text)
{
    constexpr qsizetype width = 12;
    QString padded;
    for (qsizetype i = 0; i < text.size();) {
        qsizetype end = i;
        while (end < text.size() && text.at(end).isDigit())
            ++end;
        if (end > i)
            padded += text.mid(i, end - i).rightJustified(width, u'0');
        else
            padded += text.at(end++);
        i = end;
    }
    return padded;
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
    beginResetModel();
    m_rows = std::move(rows);
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
    const bool hasOtherTags = known->trial.tags != row.trial.tags;
    *known = std::move(row);
    const auto shown = std::ranges::find(m_shown, static_cast<std::size_t>(known - m_rows.begin()));
    if (shown == m_shown.end())
        return;
    const int listSection = static_cast<int>(shown - m_shown.begin());
    const QStringList words = m_filter.text.toLower().split(u' ', Qt::SkipEmptyParts);
    if (passes(*known, words)) {
        // What is being written into a cell is overwritten when that changes.
        Q_EMIT dataChanged(index(listSection, 0),
                           index(listSection, hasOtherTags ? TagsColumn : TagsColumn - 1));
        return;
    }
    beginRemoveRows({}, listSection, listSection);
    m_shown.erase(shown);
    endRemoveRows();
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
    if (column < 0 || column >= ColumnCount)
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
    return parent.isValid() ? 0 : ColumnCount;
}

QString TrialModel::display(const TrialRow &row, int column) const
{
    switch (column) {
    case NameColumn:
        return QString::fromStdString(row.trial.name);
    case TeamColumn:
        return shownTeam(row.trial);
    case ClassColumn:
        return QString::fromStdString(row.trial.className);
    case TaskColumn:
        return QString::fromStdString(row.trial.task);
    case DateColumn:
        return QLocale().toString(localDate(row.trial.date), QLocale::ShortFormat);
    case RobotsColumn:
        return joined(row.trial.robotNames);
    case DurationColumn:
        return secondsText(fromSeconds(row.trial.durationS));
    case TopSpeedColumn:
        return row.topSpeed ? metricNumber(*row.topSpeed).text() : tr("not tracked");
    case ScoreColumn:
        return row.score ? scoreText(*row.score) : row.isScored ? tr("reanalyse") : QString();
    case TagsColumn:
        return joined(row.trial.tags);
    case VerdictColumn:
        return row.verdict ? verdictBadge(*row.verdict).text : QString();
    default:
        return {};
    }
}

QVariant TrialModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const TrialRow &row = this->row(index.row());
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole:
        return display(row, column);
    case Qt::EditRole:
        return column == TagsColumn ? QVariant(display(row, column)) : QVariant();
    case Qt::CheckStateRole:
        return column == StarColumn
                   ? QVariant(static_cast<int>(row.trial.starred ? Qt::Checked : Qt::Unchecked))
                   : QVariant();
    case Qt::AccessibleTextRole:
        return column == StarColumn ? QVariant(row.trial.starred ? tr("starred") : tr("not starred"))
                                    : QVariant();
    case Qt::ToolTipRole:
        if (column == TagsColumn && m_editable)
            return tr("Tags, separated by commas: double-click or F2 changes them");
        if (column == VerdictColumn && row.verdict) // a tool tip guesses at rich text
            return verdictText(*row.verdict).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
        if (column == ScoreColumn && row.score)
            return scoreLines(*row.score).join(u'\n').toHtmlEscaped();
        return column == StarColumn ? tr("Star (Ctrl+D)") : display(row, column).toHtmlEscaped();
    case Qt::TextAlignmentRole: {
        const bool number = column == DurationColumn || column == TopSpeedColumn || column == ScoreColumn;
        return QVariant::fromValue(
            Qt::Alignment(Qt::AlignVCenter | (number ? Qt::AlignRight : Qt::AlignLeft)));
    }
    case BadgeTextRole:
        return column == VerdictColumn && row.verdict && row.verdict->level() != CheckLevel::Pass
                   ? QVariant(display(row, column))
                   : QVariant();
    case BadgeStateRole:
        return row.verdict ? QVariant(static_cast<int>(verdictBadge(*row.verdict).state)) : QVariant();
    case NameRole:
        return display(row, NameColumn);
    case IdRole:
        return QVariant::fromValue(qint64(row.trial.id));
    default:
        return {};
    }
}

bool TrialModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!m_editable || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return false;
    const RecordId id = row(index.row()).trial.id;
    if (index.column() == StarColumn && role == Qt::CheckStateRole) {
        Q_EMIT starWanted(id, value.toInt() == Qt::Checked);
        return true;
    }
    if (index.column() != TagsColumn || role != Qt::EditRole)
        return false;
    QStringList tags;
    for (const QString &tag : value.toString().split(u','))
        if (!tag.trimmed().isEmpty())
            tags << tag.trimmed();
    Q_EMIT tagsWanted(id, tags);
    return true;
}

Qt::ItemFlags TrialModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (m_editable && index.column() == StarColumn)
        flags |= Qt::ItemIsUserCheckable;
    if (m_editable && index.column() == TagsColumn)
        flags |= Qt::ItemIsEditable;
    return flags;
}

QVariant TrialModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && section == StarColumn &&
        (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole))
        return tr("Star");
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case NameColumn:
        return tr("Trial");
    case TeamColumn:
        return tr("Team");
    case ClassColumn:
        return tr("Class");
    case TaskColumn:
        return tr("Task");
    case DateColumn:
        return tr("Date");
    case RobotsColumn:
        return tr("Robots");
    case DurationColumn:
        return tr("Time");
    case TopSpeedColumn:
        return tr("Top speed");
    case StarColumn:
        return QStringLiteral("★"); // the word is wider than the stars
    case ScoreColumn:
        return tr("Score");
    case VerdictColumn:
        return tr("Verdict");
    case TagsColumn:
        return tr("Tags");
    default:
        return {};
    }
}

} // namespace odo
