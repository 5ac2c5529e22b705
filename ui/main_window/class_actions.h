// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QObject>
#include <QStringList>

class QAction;
class QMenu;
class QWidget;

namespace odo {

class Workspace;

/// What a class has, and is set up once a year: its tasks, its teams, its robots. Owns the actions, and opens
/// their dialogs.
class ClassActions : public QObject
{
    Q_OBJECT
public:
    ClassActions(Workspace &workspace, QWidget &window);
    void fillMenu(QMenu &menu);
    void showTasks();

Q_SIGNALS:
    void changed(); ///< the project
    void rosterRequested();
    void reprocessRequested(const QStringList &trials);

private:
    void showClasses();
    void showRobots();
    void updateActions();

    Workspace &m_workspace;
    QWidget &m_window;
    QAction *m_tasks, *m_classes, *m_robots;
};

} // namespace odo
