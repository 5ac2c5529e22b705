// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/action_button.h"

#include <QAction>
#include <QPushButton>

namespace odo {

QPushButton *actionButton(QAction *action, const QString &text)
{
    auto *button = new QPushButton(action->icon(), text);
    button->setToolTip(action->toolTip());
    button->setAutoDefault(false);
    button->setEnabled(action->isEnabled());
    QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
    QObject::connect(action, &QAction::enabledChanged, button, &QWidget::setEnabled);
    return button;
}

} // namespace odo
