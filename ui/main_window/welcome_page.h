// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QListWidget;

namespace odo {

class FileActions;
class RecentProjects;

/// What stands in the window while no project is open: the ways in.
class WelcomePage : public QWidget
{
    Q_OBJECT
public:
    WelcomePage(FileActions &files, RecentProjects &recent, QWidget *parent = nullptr);

Q_SIGNALS:
    void recentChosen(const QString &file);

private:
    void fillRecent();
    RecentProjects &m_recent;
    QWidget *m_recentBox;
    QListWidget *m_list;
};

} // namespace odo
