// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tool_action.h"

#include "ui/views/theme_icon.h"

#include <QAction>

namespace odo {

QAction *toolAction(const QString &icon, const QString &text, const QString &shortText, const QString &tip,
                    QObject *parent)
{
    auto *action = new QAction(themeIcon(icon), text, parent);
    action->setIconText(shortText);
    action->setToolTip(tip);
    return action;
}

} // namespace odo
