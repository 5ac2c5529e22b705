// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"
#include "ui/models/trial_model.h"

#include <QComboBox>
#include <QSignalBlocker>
#include <QStringList>
#include <QTableView>
#include <QWidget>
#include <algorithm>
#include <string>

class QComboBox;
class QDateEdit;
class QHBoxLayout;
class QLayout;
class QPlainTextEdit;
class QPushButton;
class QTimer;
class QToolButton;

namespace odo {

/// A choice of words that may be long: it is as wide as so many letters, or wider.
inline QComboBox *makeChoice(const QString &name, int letters)
{
    auto *choice = new QComboBox;
    choice->setAccessibleName(name);
    choice->setToolTip(name);
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(letters);
    return choice;
}

/// Puts words (shown as others) behind the first so many entries of a choice; keeps the selection if it still
/// exists, without a signal.
inline void fillChoice(QComboBox &choice, const QStringList &words, const QStringList &shown, int kept = 1)
{
    const QString current = choice.currentData().toString();
    const QSignalBlocker quiet(&choice);
    while (choice.count() > kept)
        choice.removeItem(choice.count() - 1);
    for (int i = 0; i < words.size(); ++i)
        choice.addItem(shown.at(i), words.at(i));
    choice.setCurrentIndex(std::max(0, choice.findData(current)));
}

/// The word that is chosen; empty: that of the first entry.
inline std::string chosenWord(const QComboBox &choice)
{
    return choice.currentData().toString().toStdString();
}

/// What a trial filter can be, so that it can be chosen from.
struct FilterOffer
{
    QStringList classes, teams, tasks, robots;
    QStringList classesShown; ///< names, those that are archived with that word
    QStringList teamsShown;   ///< names or pseudonyms, one for each team
};

/// The choices above the list of trials: class, team, task, robot, dates, location (trials, archive, bin),
/// star, verdict. The text is not its own.
class TrialFilterBar : public QWidget
{
    Q_OBJECT
public:
    explicit TrialFilterBar(QWidget *parent = nullptr);
    /// Keeps what is chosen where it is still there.
    void setOffer(const FilterOffer &offer);
    TrialFilter filter() const; ///< without a text
    /// A small button at the right end.
    void addAtEnd(QToolButton *button);
    /// Narrower, its buttons show their icons alone.
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void changed();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    int widthOfWords() const;
    QComboBox *addChoice(QLayout &row, const QString &name, const QString &any);
    void showDates();
    static void makeSwitch(QToolButton &button, const QString &icon, const QString &text);

    QComboBox *m_class, *m_team, *m_task, *m_robot, *m_dates, *m_listSection;
    QDateEdit *m_from, *m_to;
    QToolButton *m_starred, *m_doubtful;
    QList<QToolButton *> m_buttons; ///< of the lower row
    QHBoxLayout *m_lower;
};

class TrialCellDelegate;
class TrialModel;

/// The list of trials in History: rows that are sorted by their headings, chosen one by one or many, and
/// opened by a double click or Enter. F2 edits the current cell, a double click tags, notes and variables.
/// Its columns are fitted to its width, whatever that becomes. GUI thread.
class TrialTable : public QTableView
{
    Q_OBJECT
public:
    /// The model must outlive it.
    explicit TrialTable(TrialModel &model, QWidget *parent = nullptr);
    /// Empty: none.
    QString currentTrial() const;
    using QTableView::edit;
    QStringList selectedTrials() const; ///< from top to bottom
    /// What is offered where a cell is edited.
    void setOffer(const FilterOffer &offer);
    /// Stores what is being written into a cell, which ends with it. A row that goes does so itself.
    void storeEdited();
    /// To be called after the rows have changed.
    void fit();

Q_SIGNALS:
    void opened(const QString &trial);

protected:
    bool edit(const QModelIndex &index, EditTrigger trigger, QEvent *event) override;
    void rowsAboutToBeRemoved(const QModelIndex &parent, int first, int last) override;
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    static bool isEditedByDoubleClick(const QModelIndex &index);
    TrialCellDelegate *m_cells;
};

class Card;
class FactList;
class Project;

/// What is known of one trial: where it belongs, its metrics, and the notes, which are saved while they are
/// written.
class TrialDetail : public QWidget
{
    Q_OBJECT
public:
    explicit TrialDetail(Project &project, QWidget *parent = nullptr);
    ~TrialDetail() override;

    /// Its metrics are read from the project.
    void showTrial(const TrialRow &row);
    /// Stores what is being written now instead of in a moment.
    void saveNotes();
    /// Nothing is selected; noTrials: because the project has none.
    void showNone(bool noTrials);

Q_SIGNALS:
    void openRequested(const QString &trial);
    void notesChanged(const QString &trial);
    void failed(const odo::Error &error);

private:
    Project &m_project;
    RecordId m_trial = 0;
    QString m_name;
    QString m_savedNotes;
    Card *m_card;
    FactList *m_facts;
    QPlainTextEdit *m_notes;
    QPushButton *m_open;
    QTimer *m_saveTimer;
};

} // namespace odo
