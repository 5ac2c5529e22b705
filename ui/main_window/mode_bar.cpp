// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/mode_bar.h"

#include "ui/views/command_names.h"
#include "ui/views/theme_icon.h"

#include <QAction>
#include <QActionGroup>
#include <QToolButton>
#include <QVBoxLayout>

namespace odo {
namespace {
constexpr int barWidth = 84;
constexpr int iconSide = 24;
const QColor iconColour(0xdc, 0xe3, 0xe9);
} // namespace

ModeBar::ModeBar(QWidget *parent)
    : QFrame(parent), m_group(new QActionGroup(this)), m_layout(new QVBoxLayout(this))
{
    setObjectName(QStringLiteral("modeBar"));
    setAccessibleName(tr("Modes"));
    m_layout->setContentsMargins(0, 8, 0, 8);
    m_layout->setSpacing(0);
    m_layout->addStretch(1);
    connect(m_group, &QActionGroup::triggered, this,
            [this](QAction *action) { Q_EMIT chosen(action->data().toInt()); });
}

void ModeBar::addMode(const QString &icon, const QString &name)
{
    const int mode = static_cast<int>(m_group->actions().size());
    auto *action = new QAction(themeIcon(icon, iconColour), name, m_group);
    nameCommands({{action, icon.toLatin1().constData()}});
    action->setCheckable(true);
    action->setIconVisibleInMenu(false); // it is drawn for the dark bar
    action->setData(mode);
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + mode)));
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(name, action->shortcut().toString(QKeySequence::NativeText)));
    auto *button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({iconSide, iconSide});
    button->setFixedWidth(barWidth);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(name);
    m_layout->insertWidget(mode, button);
}

void ModeBar::setCurrent(int mode)
{
    const QList<QAction *> modes = m_group->actions();
    if (mode >= 0 && mode < modes.size())
        modes.at(mode)->setChecked(true);
}

void ModeBar::setModesEnabled(bool enabled)
{
    m_group->setEnabled(enabled);
}

QList<QAction *> ModeBar::modeActions() const
{
    return m_group->actions();
}

} // namespace odo
