// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/main_window/project_pages.h"
#include "ui/views/widgets/theme.h"

#include <QList>
#include <QMenu>
#include <QObject>

class QAction;
class QActionGroup;
class QMainWindow;
class QMenu;
class QMenuBar;

namespace odo {

class ModeBar;
class TrialActions;
class ViewActions;

/// The menus View, Trial and Tools: what is always in them, and the actions of the pages, which come when a
/// page is made and go with it. GUI thread.
class PageMenus
{
public:
    /// The bar owns the menus, and must outlive them.
    PageMenus(QMenuBar &bar, const ModeBar &modes, ViewActions &views, TrialActions &trials);
    /// Of a page that was made.
    void add(ProjectPages &pages, WindowMode mode);
    /// What works on the list of trials can be chosen only where that is seen.
    void setShown(WindowMode mode) { m_history->setEnabled(mode == WindowMode::History); }
    /// Before the pages go.
    void clear();

private:
    QMenu *m_view, *m_trial, *m_range, *m_spikes, *m_history, *m_record, *m_play, *m_tools;
};

class DockDesk;

/// How the window looks: theme, full screen, which docks are there, what the charts show. Owns the actions;
/// the theme is kept in the settings.
class ViewActions : public QObject
{
    Q_OBJECT
public:
    explicit ViewActions(QMainWindow &window);
    void fillMenu(QMenu &menu);
    /// One more, before full screen.
    void addAction(QAction *action);
    /// The docks that are shown and reset, and more actions beside them; nullptr: none.
    void setDesk(DockDesk *desk, const QList<QAction *> &more = {});
    /// The desktop may have changed its own theme.
    void followDesktop();
    Theme theme() const { return m_theme; }
    void chooseTheme(odo::Theme theme);

private:
    QMainWindow &m_window;
    DockDesk *m_desk = nullptr;
    QMenu *m_menu = nullptr;
    QActionGroup *m_themes;
    QList<QAction *> m_deskActions;
    QAction *m_resetLayout, *m_fullScreen;
    Theme m_theme;
};

class Project;
class Workspace;

/// Undo and Redo of what a person changed in the open project, with the words of the change in the menu. Owns
/// the actions. GUI thread.
class UndoActions : public QObject
{
    Q_OBJECT
public:
    UndoActions(Workspace &workspace, QObject *parent);
    /// The words are looked up when the menu is about to show.
    void fillMenu(QMenu &menu);

Q_SIGNALS:
    /// What is still being written (notes) must be stored now, for it is the last change.
    void aboutToSearch();
    /// The project is another one now; words: what was done, as a sentence.
    void changed(const QString &words);
    void failed(const odo::Error &error);

private:
    void showWords();
    void apply(Result<Message> (Project::*what)(), const QString &sentence);

    Workspace &m_workspace;
    QAction *m_undo, *m_redo;
};

} // namespace odo
