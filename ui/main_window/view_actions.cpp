// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/view_actions.h"

#include "ui/views/command_names.h"
#include "ui/views/dock_desk.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

namespace odo {
namespace {
const QString themeKey = QStringLiteral("theme");
}

ViewActions::ViewActions(QMainWindow &window)
    : QObject(&window), m_window(window), m_themes(new QActionGroup(this)),
      m_resetLayout(new QAction(tr("&Reset layout"), this)),
      m_fullScreen(new QAction(tr("&Full screen"), this)),
      m_theme(themeFromName(QSettings().value(themeKey).toString()))
{
    const auto addTheme = [this](Theme theme, const QString &text) {
        QAction *action = m_themes->addAction(text);
        action->setCheckable(true);
        action->setChecked(theme == m_theme);
        connect(action, &QAction::triggered, this, [this, theme] { chooseTheme(theme); });
    };
    addTheme(Theme::System, tr("Colours of the &desktop"));
    addTheme(Theme::Light, tr("&Light"));
    addTheme(Theme::Dark, tr("Da&rk"));
    nameCommands({{m_fullScreen, "fullScreen"}, {m_resetLayout, "resetLayout"}});
    m_fullScreen->setShortcut(QKeySequence(Qt::Key_F11));
    m_fullScreen->setCheckable(true);
    connect(m_fullScreen, &QAction::toggled, this,
            [this](bool full) { full ? m_window.showFullScreen() : m_window.showNormal(); });
    m_resetLayout->setEnabled(false);
    connect(m_resetLayout, &QAction::triggered, this, [this] { m_desk->resetLayout(); });
    if (m_theme != Theme::System)
        applyAppearance(*qApp, m_theme);
}

void ViewActions::fillMenu(QMenu &menu)
{
    m_menu = &menu;
    menu.addSeparator();
    menu.addActions({m_resetLayout, m_fullScreen});
    menu.addSeparator();
    menu.addActions(m_themes->actions());
}

void ViewActions::setDesk(DockDesk *desk, const QList<QAction *> &more)
{
    m_desk = desk;
    m_resetLayout->setEnabled(desk != nullptr);
    for (QAction *action : m_deskActions)
        m_menu->removeAction(action);
    m_deskActions = desk ? desk->dockActions() + more : QList<QAction *>();
    m_menu->insertActions(m_resetLayout, m_deskActions);
}

void ViewActions::chooseTheme(Theme theme)
{
    m_theme = theme;
    m_themes->actions().at(static_cast<int>(theme))->setChecked(true);
    QSettings().setValue(themeKey, themeName(theme));
    applyAppearance(*qApp, theme);
}

void ViewActions::followDesktop()
{
    if (m_theme == Theme::System)
        applyAppearance(*qApp, Theme::System);
}

} // namespace odo
