// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window/appearance.h"

#include <QList>
#include <QObject>

class QAction;
class QActionGroup;
class QMainWindow;
class QMenu;

namespace odo {

class DockDesk;

/// How the window looks: theme, full screen, which docks are there, what the charts show. Owns the actions; the theme is kept in
/// the settings.
class ViewActions : public QObject
{
    Q_OBJECT
public:
    explicit ViewActions(QMainWindow &window);
    void fillMenu(QMenu &menu);
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

} // namespace odo
