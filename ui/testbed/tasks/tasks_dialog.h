// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/repositories.h"
#include "ui/models/project_changes.h"

#include <QDialog>
#include <QStringList>
#include <functional>
#include <map>
#include <string>
#include <vector>

class QCheckBox;
class QLabel;
class QLayout;
class QPushButton;
class QTableWidget;

namespace odo {

class Project;
class TaskCanvas;
struct TaskDraft;

/// The tasks of a project: create from templates, change, copy, rename, archive, delete, each as one change
/// that can be undone, here too (Ctrl+Z undoes changes made here). Shows what depends on each, and offers to
/// reanalyse trials that used another course. On the project's thread; the project must outlive it.
class TasksDialog : public QDialog
{
    Q_OBJECT
public:
    explicit TasksDialog(Project &project, bool readOnly = false, QWidget *parent = nullptr);

    /// As the buttons, without asking: stores a new task or another course.
    bool store(const TaskRecord &task, const std::vector<Criterion> &scoring);

Q_SIGNALS:
    void changed(); ///< the project
    /// Sent when the dialog has closed: reanalyse these trials.
    void reprocessRequested(const QStringList &trials);

private:
    QWidget *makeList();
    QLayout *makePreview();
    void addKeys();
    void refresh(const QString &choose);
    void showCurrent();
    QString wordsOf(const TaskRecord &task);
    void showButtons();
    const TaskRecord *current() const;
    void edit(const TaskDraft &draft);
    void makeNew(TaskTemplate kind);
    void change();
    void copy();
    void rename();
    void archive();
    void remove();
    void measureAgain();
    bool apply(const Message &words, const QString &choose, const std::function<Result<void>()> &work);
    void showOutcome(const Result<QString> &outcome);
    void undo(const Result<QString> &outcome);
    QString freeName(const QString &stem) const;

    Project &m_project;
    OwnChanges m_changes;
    const bool m_readOnly;
    std::vector<TaskRecord> m_tasks;
    std::vector<std::size_t> m_shown; ///< of them, one a row
    std::map<RecordId, TaskUse> m_uses;
    std::map<std::string, QStringList>
        m_otherwiseOf;       ///< trials that were measured by another course, by task
    QStringList m_otherwise; ///< those of the chosen task
    QTableWidget *m_table;
    TaskCanvas *m_canvas;
    QLabel *m_words, *m_message;
    QPushButton *m_new, *m_edit, *m_copy, *m_rename, *m_archive, *m_remove, *m_measure;
    QCheckBox *m_showArchived;
};

} // namespace odo
