// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/project_changes.h"

#include <QAction>
#include <QString>
#include <functional>
#include <initializer_list>
#include <utility>

class QAction;
class QEvent;
class QPushButton;
class QWidget;

namespace odo {

/// A button that triggers an action and is enabled with it; text: with its mnemonic, if it is to have one. In
/// a dialog it never takes the Enter key, which belongs to the default button.
QPushButton *actionButton(QAction *action, const QString &text);

/// Names by which the settings know commands, whatever language their words are in. A command with a name can
/// be given another key.
inline void nameCommands(std::initializer_list<std::pair<QAction *, const char *>> commands)
{
    for (const auto &[action, name] : commands)
        action->setObjectName(QString::fromLatin1(name));
}

/// For event() of a page on which Space plays: Space belongs to the button or list that has the focus before
/// that. True: the event was dealt with.
bool keepSpaceForFocus(QEvent &event);

/// A button of a dialog that never takes the Enter key, which belongs to the default button; not before it is
/// made the default one itself.
QPushButton *plainButton(const QString &text);

/// Gives a dialog the keys to undo (Ctrl+Z) and redo (Ctrl+Shift+Z) its changes; showOutcome gets the
/// outcome. The changes must outlive the dialog's keys. GUI thread.
void addUndoKeys(QWidget &dialog, OwnChanges &changes,
                 const std::function<void(const Result<QString> &)> &showOutcome);

} // namespace odo
