// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/scoring.h"
#include "core/base/error.h"
#include "core/project/records.h"
#include "core/project/verdict_repository.h"
#include "core/workflow/trials/trial_changes.h"

#include <QAbstractTableModel>
#include <QString>
#include <QStringList>
#include <optional>
#include <set>
#include <vector>

namespace odo {

/// Which trials of a list are shown. Everything that is set must hold.
struct TrialFilter
{
    enum class ListSection { Active, Archived, Bin };
    /// Each word of it must occur in the trial's search text; case does not matter.
    QString text;
    std::string className, team, task, robot; ///< by name; empty: any
    /// whose trials count as archived unless the class is chosen by name
    std::set<std::string> archivedClasses;
    bool starred = false;  ///< only those
    bool doubtful = false; ///< only those with doubtful or bad results, accepted ones too
    ListSection listSection = ListSection::Active;
    std::optional<Instant> from, to; ///< from included, to excluded
};

/// Tags as a person writes them, separated by commas.
std::vector<std::string> tagsOf(const QString &written);

/// The search text of a trial, in lower case: names, pseudonym, date, notes, tags.
QString searchTextOf(const TrialRecord &trial);

/// words: of the filter's text, in lower case; searchText: searchTextOf the trial.
bool isShown(const TrialFilter &filter, const QStringList &words, const TrialRecord &trial,
             const QString &searchText);

class Project;

/// A trial in the list, with the metric that the list shows.
struct TrialRow
{
    TrialRecord trial;
    std::optional<Metric> topSpeed;  ///< of its fastest robot; nullopt: not tracked
    QString searchText;              ///< searchTextOf(trial)
    std::optional<Score> score = {}; ///< of its best robot
    bool isScored = false;           ///< its task is; without a score it was measured otherwise
    /// nullopt: not analysed, or to be computed (isUnchecked)
    std::optional<TrialVerdict> verdict = {};
    bool isUnchecked = false; ///< it is analysed, but its verdict is not stored
};

/// Reads the trials of a project piece by piece, newest first, so that thousands of them never keep the
/// window waiting. On the project's thread; the project must outlive it.
class TrialRows
{
public:
    explicit TrialRows(Project &project) : m_project(&project) {}
    /// The next rows; none: all were read.
    Result<std::vector<TrialRow>> next(int count);

private:
    Project *m_project;
    std::optional<TrialRecord> m_last;
};

/// One of them. On the project's thread.
Result<TrialRow> loadTrialRow(Project &project, RecordId trial);

/// The trials of a project that pass a filter, sorted by a column. Filters ten thousand in milliseconds: no
/// proxy model, because a proxy notifies the view of each removed range. GUI thread.
class TrialModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Columns {
        NameColumn,
        TeamColumn,
        ClassColumn,
        TaskColumn,
        DateColumn,
        RobotsColumn,
        DurationColumn,
        TopSpeedColumn,
        ScoreColumn,
        VerdictColumn,
        StarColumn, ///< checkable
        TagsColumn, ///< separated by commas
        NotesColumn,
        ColumnCount ///< the first of variables(), a column each
    };
    enum Roles {
        NameRole = Qt::UserRole, ///< QString, of the row's trial
        IdRole,                  ///< qint64, of the row's trial
        BadgeTextRole,           ///< of the verdict, where it is no pass
        BadgeStateRole,
    };

    explicit TrialModel(QObject *parent = nullptr);
    void setRows(std::vector<TrialRow> rows);
    /// Replaces the row of the same trial; it stays where it is until the list is sorted or filtered again,
    /// unless the filter does not let it through any more.
    void updateRow(TrialRow row);
    /// As updateRow, of a trial's verdict that was computed.
    void updateVerdict(const StoredVerdict &verdict);
    /// Trials whose verdict is to be computed, as the list was read.
    std::vector<RecordId> unchecked() const;
    void setFilter(TrialFilter filter);
    const TrialFilter &filter() const { return m_filter; }
    /// Teams are shown by another name now (shownTeam).
    void updateTeams();
    /// People's own variables of all trials, in alphabetical order; those that came since behind them.
    const QStringList &variables() const { return m_variables; }
    /// Whether stars, names, teams, classes, tasks, dates, tags, notes of one line and variables can be
    /// changed in place.
    void setEditable(bool editable) { m_editable = editable; }

    const TrialRow &row(int index) const { return m_rows.at(m_shown.at(static_cast<std::size_t>(index))); }
    int indexOf(const QString &trial) const; ///< −1: not shown
    const std::vector<TrialRow> &allRows() const { return m_rows; }
    /// However few are shown.
    int allCount() const { return static_cast<int>(m_rows.size()); }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

Q_SIGNALS:
    /// A person changed a cell; the row follows by updateRow, once it is stored.
    void starWanted(qint64 trial, bool starred);
    void editWanted(qint64 trial, const odo::TrialEdit &edit);

private:
    QString display(const TrialRow &row, int column) const;
    QVariant editedValue(const TrialRow &row, int column) const;
    bool isEditable(const TrialRow &row, int column) const;
    TrialEdit editOf(int column, const QVariant &value) const;
    QString toolTip(const TrialRow &row, int column) const;
    /// Those of a row that are not known yet.
    void addVariables(const TrialRow &row);
    void showChanged(int row, const TrialRow &before);
    bool passes(const TrialRow &row, const QStringList &words) const;
    void choose();  ///< fills m_shown by the filter, sorted
    void arrange(); ///< sorts m_shown

    std::vector<TrialRow> m_rows;
    QStringList m_variables;
    std::vector<std::size_t> m_shown; ///< indices into m_rows
    TrialFilter m_filter;
    int m_sortColumn = DateColumn;
    Qt::SortOrder m_sortOrder = Qt::DescendingOrder;
    bool m_editable = false;
};

} // namespace odo
