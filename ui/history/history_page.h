// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"
#include "core/school/hub_address.h"

#include <QList>
#include <QStringList>
#include <QWidget>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

class QAction;
class QLineEdit;
class QPushButton;
class QTabWidget;
class QTimer;

namespace odo {

struct BinContent;
class Card;
class HubRunsPanel;
class MarkActions;
class Project;
class ProjectReader;
class ResultsPanel;
class TeamsPanel;
class TrialColumns;
class TrialDetail;
class TrialFilterBar;
class TrialModel;
class TrialRows;
class TrialTable;
struct StoredVerdict;
struct TrialRow;

/// History: all trials of the project, searched, filtered, sorted, marked and opened; what is known of the
/// one that is selected. Thousands of trials are read piece by piece. Uses the project on its own thread. The
/// project must outlive the page.
class HistoryPage : public QWidget
{
    Q_OBJECT
public:
    explicit HistoryPage(Project &project, bool readOnly = false, QWidget *parent = nullptr);
    ~HistoryPage() override;

    /// Reads the project, keeping the selection. Call it once the signals are connected, and after every
    /// change.
    void refresh();
    /// The school's hub that the project is connected to, whose runs can be looked at as well; nullopt: none.
    void setHub(const std::optional<HubAddress> &hub);
    /// At once, or as soon as it was read.
    void selectTrial(const QString &name);
    /// Stores what is being written now instead of in a moment.
    void saveNotes();
    /// Everything that was to be read is there.
    bool isSettled() const;
    /// That only pseudonyms of teams are shown, in every mode, where they have one: a checkable action for a
    /// menu. Remembered.
    QAction *pseudonyms() const { return m_pseudonyms; }
    /// From top to bottom.
    QStringList selectedTrials() const;
    /// A command on the selected trials that is in a menu already: for the list's own.
    void addEditAction(QAction *action);
    /// What can be done with the list and the trials that are selected in it, for a menu.
    const QList<QAction *> &listActions() const { return m_listActions; }

Q_SIGNALS:
    void trialChosen(const QString &name);            ///< to be opened in Review
    void compareRequested(const QStringList &trials); ///< two or more
    void exportRequested(const QStringList &trials);
    void videosRequested(const QStringList &trials); ///< annotated ones are to be made
    void reportRequested(const QStringList &trials);
    void reprocessRequested(const QStringList &trials);     ///< to be reanalysed
    void emptyBinRequested(const odo::BinContent &content); ///< confirmed
    void selectionChanged(const QStringList &trials);
    void notesChanged(const QString &trial);
    /// Trials were edited, moved to the bin or restored; words: a message, or empty.
    void trialsChanged(const QString &words);
    /// Teams are shown by another name now.
    void teamNamesChanged();
    void tableSaved(const QString &file); ///< of results
    void failed(const odo::Error &error);
    void settled();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    QWidget *makeTable();
    void makeHeader();
    void addTrialActions();
    void showChosenTab();
    void giveTrialsToTeams();
    void showSettled();
    void connectMarks();
    std::set<RecordId> selectedIds() const;
    void selectAgain(const std::set<RecordId> &trials, RecordId current);
    void readMore();
    void endReading(std::vector<TrialRow> rows);
    void checkMore();
    void takeVerdicts(Result<std::vector<StoredVerdict>> verdicts);
    void offerFilters();
    void filter();
    void reload(const QList<qint64> &trials);
    void showCurrent();
    void showSelection();
    void showCount();

    Project &m_project;
    const bool m_readOnly;
    TrialModel *m_trials;
    QLineEdit *m_search;
    QPushButton *m_compare;
    TrialFilterBar *m_filterBar;
    MarkActions *m_marks;
    QAction *m_pseudonyms;
    QList<QAction *> m_listActions;
    TrialTable *m_table;
    TrialColumns *m_columns;
    Card *m_tableCard = nullptr;
    ResultsPanel *m_results;
    TeamsPanel *m_teams;
    HubRunsPanel *m_hubRuns;
    QTabWidget *m_tabs;
    TrialDetail *m_detail;
    ProjectReader *m_checker;
    QTimer *m_readTimer;
    std::set<std::string> m_archivedClasses;
    std::unique_ptr<TrialRows> m_reading; ///< null: all was read
    std::vector<TrialRow> m_read;         ///< so far
    std::vector<RecordId> m_unchecked;    ///< trials whose verdict is still to be computed
    QList<qint64> m_changed;              ///< trials whose rows are being reloaded
    QString m_wanted;                     ///< to be selected once it was read; empty: none
};

} // namespace odo
