// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/tasks_dialog.h"

#include "core/analysis/metric_table.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "ui/models/results.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/tasks/internal/task_canvas.h"
#include "ui/testbed/tasks/internal/task_editor.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/table_list.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QTableWidget>
#include <algorithm>
#include <optional>
#include <vector>

namespace odo {

class Project;

/// The marker layout of the cameras, for a task lies among their markers; else the first one that there is.
/// Project's thread.
std::optional<MarkerLayout> layoutForTasks(Project &project)
{
    for (const CameraRecord &camera : project.cameras().all().value_or(std::vector<CameraRecord>())) {
        const auto registration = project.cameras().currentRegistration(camera.id);
        if (!registration || !*registration)
            continue;
        if (const auto layout = project.layouts().get((*registration)->layout))
            return layout->layout;
    }
    const auto layouts = project.layouts().all();
    return layouts && !layouts->empty() ? std::optional(layouts->front().layout) : std::nullopt;
}

/// What an editor of a task begins with. task: of the project, or a new one (id 0); all: those that there
/// are. Project's thread.
TaskDraft draftOfTask(Project &project, const TaskRecord &task, const std::vector<TaskRecord> &all)
{
    TaskDraft draft;
    draft.task = task;
    for (const TaskRecord &each : all)
        if (each.id != task.id)
            draft.taken << QString::fromStdString(each.name);
    for (const MetricKind &kind : metricKinds())
        if (kind.isScored())
            draft.metrics.emplace_back(kind.id);
    for (const std::string &name : project.analyses().metricNames().value_or(std::vector<std::string>()))
        if (std::ranges::find(draft.metrics, name) == draft.metrics.end())
            draft.metrics.push_back(name);
    if (task.id != 0)
        draft.scoring = project.tasks().scoring(task.id).value_or(std::vector<Criterion>());
    draft.layout = layoutForTasks(project);
    return draft;
}

namespace {

struct TaskColumn
{
    enum { Name, Template, Use, Count };
};
constexpr int listWidth = 430;

} // namespace

TasksDialog::TasksDialog(Project &project, bool readOnly, QWidget *parent)
    : QDialog(parent), m_project(project), m_changes(project), m_readOnly(readOnly),
      m_table(new QTableWidget(0, TaskColumn::Count)), m_canvas(new TaskCanvas), m_words(new QLabel),
      m_message(new QLabel), m_new(plainButton(tr("&New"))), m_edit(plainButton(tr("&Edit…"))),
      m_copy(plainButton(tr("&Copy…"))), m_rename(plainButton(tr("&Rename…"))),
      m_archive(plainButton(tr("&Archive"))), m_remove(plainButton(tr("&Delete"))),
      m_measure(plainButton(tr("Reanalyse &them"))), m_showArchived(new QCheckBox)
{
    setWindowTitle(tr("Tasks"));
    for (QLabel *label : {m_words, m_message}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    m_words->setAccessibleName(tr("What depends on the task"));
    m_message->setAccessibleName(tr("Latest change"));
    auto *row = new QHBoxLayout;
    row->addWidget(makeList());
    row->addLayout(makePreview(), 1);
    auto *close = plainButton(tr("Close"));
    close->setDefault(true);
    auto *bottom = new QHBoxLayout;
    bottom->addWidget(m_message, 1);
    bottom->addWidget(close);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(row, 1);
    layout->addLayout(bottom);
    resize(QSize(1000, 600).boundedTo(screen()->availableSize() * 0.95));
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    addKeys();
    refresh({});
}

QWidget *TasksDialog::makeList()
{
    m_table->setHorizontalHeaderLabels({tr("Task"), tr("Template"), tr("Used by")});
    m_table->setAccessibleName(tr("Tasks"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setWordWrap(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(TaskColumn::Name, QHeaderView::Stretch);
    auto *templates = new QMenu(m_new);
    for (const TaskTemplate kind : {TaskTemplate::StraightLine, TaskTemplate::Circle,
                                    TaskTemplate::FigureEight, TaskTemplate::Slalom, TaskTemplate::Free})
        templates->addAction(templateName(kind), this, [this, kind] { makeNew(kind); });
    m_new->setMenu(templates);
    auto *tools = new QHBoxLayout;
    for (QPushButton *button : {m_new, m_edit, m_copy, m_rename})
        tools->addWidget(button);
    auto *more = new QHBoxLayout;
    for (QPushButton *button : {m_archive, m_remove})
        more->addWidget(button);
    more->addStretch(1);
    more->addWidget(m_showArchived);
    m_archive->setToolTip(
        tr("Archived tasks no longer appear in lists; their trials, results and scores stay as they are"));
    auto *list = new QWidget;
    list->setFixedWidth(listWidth);
    auto *layout = new QVBoxLayout(list);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table, 1);
    layout->addLayout(tools);
    layout->addLayout(more);
    connect(m_archive, &QPushButton::clicked, this, &TasksDialog::archive);
    connect(m_showArchived, &QCheckBox::toggled, this,
            [this] { refresh(current() ? QString::fromStdString(current()->name) : QString()); });
    connect(m_edit, &QPushButton::clicked, this, &TasksDialog::change);
    connect(m_copy, &QPushButton::clicked, this, &TasksDialog::copy);
    connect(m_rename, &QPushButton::clicked, this, &TasksDialog::rename);
    connect(m_remove, &QPushButton::clicked, this, &TasksDialog::remove);
    connect(m_table, &QTableWidget::currentCellChanged, this, &TasksDialog::showCurrent);
    connect(m_table, &QTableWidget::cellDoubleClicked, this, &TasksDialog::change);
    return list;
}

QLayout *TasksDialog::makePreview()
{
    m_canvas->setEditable(false);
    m_canvas->setToolTip({});
    m_canvas->setFocusPolicy(Qt::NoFocus);
    m_canvas->setLayout(layoutForTasks(m_project));
    auto *again = new QHBoxLayout;
    again->addWidget(m_measure);
    again->addStretch(1);
    auto *preview = new QVBoxLayout;
    preview->addWidget(m_canvas, 1);
    preview->addWidget(m_words);
    preview->addLayout(again);
    connect(m_measure, &QPushButton::clicked, this, &TasksDialog::measureAgain);
    return preview;
}

void TasksDialog::addKeys()
{
    const auto add = [this](const QKeySequence &keys, auto slot) {
        auto *action = new QAction(this);
        action->setShortcut(keys);
        connect(action, &QAction::triggered, this, slot);
        addAction(action);
    };
    addUndoKeys(*this, m_changes, [this](const Result<QString> &outcome) { undo(outcome); });
    add(QKeySequence(Qt::Key_F2), [this] { rename(); });
    add(QKeySequence(Qt::Key_Delete), [this] { remove(); });
}

void TasksDialog::refresh(const QString &choose)
{
    auto tasks = m_project.tasks().all();
    auto uses = m_project.tasks().uses();
    if (!tasks || !uses) {
        m_message->setText(errorLine(tasks ? uses.error() : tasks.error()));
        return;
    }
    m_tasks = std::move(*tasks);
    m_uses = std::move(*uses);
    std::ranges::stable_sort(m_tasks, {}, &TaskRecord::name);
    const auto archived =
        std::ranges::count_if(m_tasks, [](const TaskRecord &task) { return task.archived.has_value(); });
    m_showArchived->setText(tr("Show %n archived task(s)", "", static_cast<int>(archived)));
    m_showArchived->setVisible(archived > 0);
    m_shown.clear();
    for (std::size_t i = 0; i < m_tasks.size(); ++i)
        if (!m_tasks[i].archived || m_showArchived->isChecked())
            m_shown.push_back(i);
    m_otherwiseOf.clear();
    for (const OtherwiseMeasured &trial :
         m_project.analyses().trialsMeasuredOtherwise().value_or(std::vector<OtherwiseMeasured>()))
        if (!trial.binned)
            m_otherwiseOf[trial.task] << QString::fromStdString(trial.name);
    int row = 0;
    m_table->setRowCount(static_cast<int>(m_shown.size()));
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const TaskRecord &task = m_tasks[m_shown[static_cast<std::size_t>(i)]];
        const TaskUse use = m_uses[task.id];
        const QString name = QString::fromStdString(task.name);
        const QString used = use.trials > 0     ? tr("%n trial(s)", "", use.trials)
                             : use.analyses > 0 ? tr("earlier results")
                                                : tr("nothing");
        const QString words = task.archived ? tr("%1, archived").arg(used) : used;
        m_table->setItem(i, TaskColumn::Name, new QTableWidgetItem(name));
        m_table->item(i, TaskColumn::Name)->setToolTip(name.toHtmlEscaped());
        m_table->setItem(i, TaskColumn::Template, new QTableWidgetItem(templateName(task.task.kind)));
        m_table->setItem(i, TaskColumn::Use, new QTableWidgetItem(words));
        if (name == choose)
            row = i;
    }
    m_table->setCurrentCell(m_shown.empty() ? -1 : row, 0);
    showCurrent();
}

const TaskRecord *TasksDialog::current() const
{
    const int row = m_table->currentRow();
    return row >= 0 && row < static_cast<int>(m_shown.size())
               ? &m_tasks[m_shown[static_cast<std::size_t>(row)]]
               : nullptr;
}

void TasksDialog::showCurrent()
{
    const TaskRecord *task = current();
    m_otherwise.clear();
    showButtons();
    m_canvas->setTask(task ? task->task : Task());
    if (!task) {
        m_words->setText(tr("No task yet. New creates one from a template. Its gates, path and scoring "
                            "define the course and rate the runs."));
        m_measure->hide();
        return;
    }
    if (const auto otherwise = m_otherwiseOf.find(task->name); otherwise != m_otherwiseOf.end())
        m_otherwise = otherwise->second;
    m_words->setText(wordsOf(*task));
    m_measure->setVisible(!m_otherwise.isEmpty() && !m_readOnly);
}

QString TasksDialog::wordsOf(const TaskRecord &task)
{
    const TaskUse use = m_uses[task.id];
    QStringList words;
    if (isEarlierVersion(task, use))
        words << tr("Earlier version of the course: %n result(s) still use it.", "", use.analyses);
    else
        words << (use.trials > 0 ? tr("%n trial(s) have this task.", "", use.trials)
                                 : tr("No trial has this task."));
    if (!m_otherwise.isEmpty())
        words << tr("%n of them were measured with another course: their gate times and distances from the "
                    "path belong to that one, and they have no score until you reanalyse them.",
                    "", static_cast<int>(m_otherwise.size()));
    const auto scoring = m_project.tasks().scoring(task.id);
    words << (scoring && !scoring->empty()
                  ? tr("It is scored by %n metric(s).", "", static_cast<int>(scoring->size()))
                  : tr("It is not scored."));
    return words.join(u' ');
}

void TasksDialog::showButtons()
{
    const TaskRecord *task = current();
    const bool able = task && !m_readOnly;
    const bool earlier = task && isEarlierVersion(*task, m_uses[task->id]);
    m_new->setEnabled(!m_readOnly);
    m_copy->setEnabled(able);
    m_edit->setEnabled(able && !earlier);
    m_rename->setEnabled(able && !earlier);
    m_archive->setEnabled(able && !earlier);
    m_archive->setText(task && task->archived ? tr("Restore from &archive") : tr("&Archive"));
    const bool used =
        task && m_uses.contains(task->id) && (m_uses[task->id].trials > 0 || m_uses[task->id].analyses > 0);
    m_remove->setEnabled(able && !used);
    m_remove->setToolTip(
        used ? tr("Trials have this task or were measured with it: it stays to document their metrics")
             : tr("Deletes the task (Del); Ctrl+Z undoes this"));
}

QString TasksDialog::freeName(const QString &stem) const
{
    const auto taken = [this](const QString &name) {
        return std::ranges::find(m_tasks, name.toStdString(), &TaskRecord::name) != m_tasks.end();
    };
    QString name = stem;
    for (int number = 2; taken(name); ++number)
        name = QStringLiteral("%1 (%2)").arg(stem).arg(number);
    return name;
}

void TasksDialog::makeNew(TaskTemplate kind)
{
    TaskRecord task;
    task.name = freeName(templateName(kind)).toStdString();
    task.task.kind = kind;
    edit(draftOfTask(m_project, task, m_tasks));
}

void TasksDialog::change()
{
    const TaskRecord *task = current();
    if (!task || !m_edit->isEnabled())
        return;
    TaskDraft draft = draftOfTask(m_project, *task, m_tasks);
    if (const int trials = m_uses[task->id].analyses; trials > 0)
        draft.remark = tr("%n result(s) measured with this course stay valid: if you change the course, they "
                          "keep the earlier version. Reanalyse the trials to update their times and scores.",
                          "", trials);
    edit(draft);
}

void TasksDialog::copy()
{
    const TaskRecord *task = current();
    if (!task || m_readOnly)
        return;
    TaskDraft draft = draftOfTask(m_project, *task, m_tasks);
    draft.taken << QString::fromStdString(task->name);
    draft.task.id = 0;
    draft.task.name = freeName(QString::fromStdString(task->name)).toStdString();
    edit(draft);
}

void TasksDialog::edit(const TaskDraft &draft)
{
    TaskEditor editor(draft, this);
    if (editor.exec() == QDialog::Accepted)
        store(editor.task(), editor.scoring());
}

bool TasksDialog::store(const TaskRecord &task, const std::vector<Criterion> &scoring)
{
    return apply(task.id == 0 ? addTaskWords(task.name)
                              : ODO_TEXT("ui.change_task", "change task %1")(Named::task(task.name)),
                 QString::fromStdString(task.name), [&]() -> Result<void> {
                     if (task.id != 0)
                         ODO_TRY(m_project.tasks().rename(task.id, task.name));
                     const auto stored =
                         ODO_TRY(task.id == 0 ? m_project.tasks().add(task) : m_project.tasks().change(task));
                     return m_project.tasks().setScoring(stored.id, scoring);
                 });
}

void TasksDialog::rename()
{
    const TaskRecord *task = current();
    if (!task || !m_rename->isEnabled())
        return;
    bool accepted = false;
    const QString before = QString::fromStdString(task->name);
    const QString name =
        QInputDialog::getText(this, tr("Rename task"), tr("Name:"), QLineEdit::Normal, before, &accepted)
            .trimmed();
    if (!accepted || name == before)
        return;
    apply(ODO_TEXT("ui.rename_task", "rename task %1 to %2")(Named::task(task->name),
                                                             Named::task(name.toStdString())),
          name, [&, id = task->id] { return m_project.tasks().rename(id, name.toStdString()); });
}

void TasksDialog::archive()
{
    const TaskRecord *task = current();
    if (!task || !m_archive->isEnabled())
        return;
    const bool to = !task->archived;
    const MessageText &words = to ? ODO_TEXT("ui.archive_task", "archive task %1")
                                  : ODO_TEXT("ui.unarchive_task", "restore task %1 from the archive");
    apply(words(Named::task(task->name)), to ? QString() : QString::fromStdString(task->name),
          [&, id = task->id] { return m_project.tasks().setArchived(id, to); });
}

void TasksDialog::remove()
{
    const TaskRecord *task = current();
    if (!task || !m_remove->isEnabled())
        return;
    apply(ODO_TEXT("ui.delete_task", "delete task %1")(Named::task(task->name)), {},
          [&, id = task->id] { return m_project.tasks().remove(id); });
}

bool TasksDialog::apply(const Message &words, const QString &choose,
                        const std::function<Result<void>()> &work)
{
    const Result<QString> done = m_changes.make(words, work);
    showOutcome(done);
    if (!done)
        return false;
    refresh(choose);
    Q_EMIT changed();
    return true;
}

void TasksDialog::showOutcome(const Result<QString> &outcome)
{
    m_message->setText(outcome ? *outcome : errorLine(outcome.error()));
}

void TasksDialog::undo(const Result<QString> &outcome)
{
    showOutcome(outcome);
    if (!outcome)
        return;
    const TaskRecord *task = current();
    refresh(task ? QString::fromStdString(task->name) : QString());
    Q_EMIT changed();
}

void TasksDialog::measureAgain()
{
    const QStringList trials = m_otherwise;
    accept();
    Q_EMIT reprocessRequested(trials);
}

} // namespace odo
