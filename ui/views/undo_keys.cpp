// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/undo_keys.h"

#include <QAction>
#include <QWidget>

namespace odo {

void addUndoKeys(QWidget &dialog, OwnChanges &changes,
                 const std::function<void(const Result<QString> &)> &tell)
{
    const auto add = [&](const QKeySequence &keys, Result<QString> (OwnChanges::*what)()) {
        auto *action = new QAction(&dialog);
        action->setShortcut(keys);
        QObject::connect(action, &QAction::triggered, &dialog,
                         [&changes, what, tell] { tell((changes.*what)()); });
        dialog.addAction(action);
    };
    add(QKeySequence(Qt::CTRL | Qt::Key_Z), &OwnChanges::undo);
    add(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), &OwnChanges::redo);
}

} // namespace odo
