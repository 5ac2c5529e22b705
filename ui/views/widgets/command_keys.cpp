// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/command_keys.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QPushButton>
#include <QWidget>

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

bool keepSpaceForFocus(QEvent &event)
{
    if (event.type() != QEvent::ShortcutOverride || static_cast<QKeyEvent &>(event).key() != Qt::Key_Space)
        return false;
    QWidget *focus = QApplication::focusWidget();
    if (!qobject_cast<QAbstractButton *>(focus) && !qobject_cast<QComboBox *>(focus))
        return false;
    event.accept();
    return true;
}

QPushButton *plainButton(const QString &text)
{
    auto *button = new QPushButton(text);
    button->setAutoDefault(false);
    return button;
}

void addUndoKeys(QWidget &dialog, OwnChanges &changes,
                 const std::function<void(const Result<QString> &)> &showOutcome)
{
    const auto add = [&](const QKeySequence &keys, Result<QString> (OwnChanges::*what)()) {
        auto *action = new QAction(&dialog);
        action->setShortcut(keys);
        QObject::connect(action, &QAction::triggered, &dialog,
                         [&changes, what, showOutcome] { showOutcome((changes.*what)()); });
        dialog.addAction(action);
    };
    add(QKeySequence(Qt::CTRL | Qt::Key_Z), &OwnChanges::undo);
    add(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), &OwnChanges::redo);
}

} // namespace odo
