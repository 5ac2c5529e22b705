// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/class_actions.h"

#include "ui/history/classes_dialog.h"
#include "ui/main_window/robots_dialog.h"
#include "ui/main_window/workspace.h"
#include "ui/testbed/tasks/tasks_dialog.h"
#include "ui/views/command_names.h"

#include <QAction>
#include <QMenu>
#include <QWidget>

namespace odo {

ClassActions::ClassActions(Workspace &workspace, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_window(window), m_tasks(new QAction(tr("&Tasks…"), this)),
      m_classes(new QAction(tr("C&lasses and teams…"), this)), m_robots(new QAction(tr("R&obots…"), this))
{
    connect(m_tasks, &QAction::triggered, this, &ClassActions::showTasks);
    connect(m_classes, &QAction::triggered, this, &ClassActions::showClasses);
    connect(m_robots, &QAction::triggered, this, &ClassActions::showRobots);
    connect(&m_workspace, &Workspace::opened, this, &ClassActions::updateActions);
    nameCommands({{m_tasks, "tasks"}, {m_classes, "classes"}, {m_robots, "robots"}});
    updateActions();
}

void ClassActions::fillMenu(QMenu &menu)
{
    menu.addActions({m_tasks, m_classes, m_robots});
}

void ClassActions::updateActions()
{
    for (QAction *action : {m_tasks, m_classes, m_robots})
        action->setEnabled(m_workspace.project() != nullptr);
}

void ClassActions::showTasks()
{
    TasksDialog dialog(*m_workspace.project(), m_workspace.isReadOnly(), &m_window);
    connect(&dialog, &TasksDialog::changed, this, &ClassActions::changed);
    QStringList again;
    connect(&dialog, &TasksDialog::reprocessRequested, this,
            [&again](const QStringList &trials) { again = trials; });
    dialog.exec();
    if (!again.isEmpty())
        Q_EMIT reprocessRequested(again);
}

void ClassActions::showClasses()
{
    ClassesDialog dialog(*m_workspace.project(), m_workspace.isReadOnly(), &m_window);
    connect(&dialog, &ClassesDialog::changed, this, &ClassActions::changed);
    bool roster = false;
    connect(&dialog, &ClassesDialog::rosterRequested, this, [&roster] { roster = true; });
    dialog.exec();
    if (roster)
        Q_EMIT rosterRequested();
}

void ClassActions::showRobots()
{
    RobotsDialog dialog(*m_workspace.project(), m_workspace.isReadOnly(), &m_window);
    connect(&dialog, &RobotsDialog::changed, this, &ClassActions::changed);
    dialog.exec();
}

} // namespace odo
