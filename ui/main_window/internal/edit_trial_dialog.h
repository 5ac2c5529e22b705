// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/workflow/trials/trial_changes.h"

#include <QDialog>
#include <QStringList>
#include <string>
#include <vector>

class QComboBox;
class QDateTimeEdit;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace odo {

class CheckList;
class Project;
class SharedField;
class TeamBox;
class VariableTable;

/// Edits a trial, or what several have in common: name, team, class, date, task, robots, tags, notes and
/// people's own variables. Where the trials differ it shows "several", which stays unless it is edited. What
/// is refused keeps the dialog open. On the project's thread; the project must outlive it.
class EditTrialDialog : public QDialog
{
    Q_OBJECT
public:
    /// trials: one or more.
    EditTrialDialog(Project &project, std::vector<TrialRecord> trials, QWidget *parent = nullptr);
    /// What differs from what is stored.
    TrialEdit edit() const;
    /// Stores it; closes the dialog only if that went well.
    void accept() override;
    /// The trials as they are stored now.
    const std::vector<TrialRecord> &trials() const { return m_trials; }

private:
    QWidget *makeForm();
    SharedField *addField(QFormLayout &form, const QString &label, QWidget *editor, bool areSame);
    void fillChoices();
    void fillValues();
    TrialEdit written() const; ///< what is in every field
    QWidget *makeVariables();
    void proposeClass();
    void showFailure(const QString &words);

    Project &m_project;
    std::vector<TrialRecord> m_trials;
    std::vector<TeamRecord> m_teams;
    TrialEdit m_before; ///< as written() at first
    QLineEdit *m_name, *m_tags;
    TeamBox *m_team;
    QComboBox *m_class, *m_task;
    QDateTimeEdit *m_date;
    CheckList *m_robots;
    QPlainTextEdit *m_notes;
    VariableTable *m_variables;
    QLabel *m_message;
    SharedField *m_nameField = nullptr, *m_teamField = nullptr, *m_classField = nullptr,
                *m_dateField = nullptr, *m_taskField = nullptr, *m_robotsField = nullptr,
                *m_tagsField = nullptr, *m_notesField = nullptr;
};

} // namespace odo
