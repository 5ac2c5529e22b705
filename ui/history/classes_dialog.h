// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/class_repository.h"
#include "core/project/records.h"
#include "ui/models/project_changes.h"

#include <QDialog>
#include <functional>
#include <vector>

class QLabel;
class QListWidget;
class QMenu;
class QPlainTextEdit;
class QPushButton;
class QTableWidget;

namespace odo {

class Project;

/// The classes of a project and their teams: made, renamed, moved, archived and deleted, each as one change
/// that can be undone, here too (Ctrl+Z undoes what was done here). Names and pseudonyms of teams are written
/// in place, members and robots in a dialog. On the project's thread; the project must outlive it.
class ClassesDialog : public QDialog
{
    Q_OBJECT
public:
    explicit ClassesDialog(Project &project, bool readOnly = false, QWidget *parent = nullptr);

Q_SIGNALS:
    void changed(); ///< the project
    /// The dialog is closed, and a roster is to be imported.
    void rosterRequested();

private:
    QWidget *makeClasses();
    QWidget *makeTeams();
    void refresh();
    void showTeams();
    void showToRead(int row, int column, const QString &text);
    void showButtons();
    const ClassRecord *currentClass() const;
    const TeamRecord *currentTeam() const;
    void addClass();
    void renameClass();
    void archiveClass();
    void removeClass();
    void addTeam();
    void moveTeam(const std::string &className);
    void removeTeam();
    void editTeam();
    void readCell(int row, int column);
    QString askName(const QString &title, const QString &name);
    void apply(const Message &words, const std::function<Result<void>()> &work);
    void showOutcome(const Result<QString> &outcome);

    Project &m_project;
    OwnChanges m_changes;
    const bool m_readOnly;
    bool m_isShowing = false;
    std::vector<ClassRecord> m_classes;
    std::vector<RobotRecord> m_robots;
    std::vector<TeamRecord> m_all, m_teams; ///< of all classes; of the one that is chosen
    QString m_wanted;                       ///< class that is chosen once it is there
    QListWidget *m_classList;
    QTableWidget *m_teamTable;
    QMenu *m_moveMenu;
    QPushButton *m_newClass, *m_rename, *m_archive, *m_removeClass, *m_newTeam, *m_move, *m_editTeam,
        *m_removeTeam, *m_roster;
    QLabel *m_message;
};

class CheckList;

/// The people of a team, a line each, and the robots that belong to it. Stores nothing: that is up to whoever
/// opened it.
class TeamDialog : public QDialog
{
    Q_OBJECT
public:
    TeamDialog(TeamRecord team, const std::vector<RobotRecord> &robots, QWidget *parent = nullptr);
    /// The team with what was written.
    TeamRecord team() const;

private:
    const TeamRecord m_team;
    const std::vector<RobotRecord> m_robots;
    QPlainTextEdit *m_members;
    CheckList *m_list;
};

/// "Anna, Ben", or, where teams are shown by pseudonym, how many they are.
QString shownMembers(const TeamRecord &team);

} // namespace odo
