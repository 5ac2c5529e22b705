// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/page_keys.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

namespace odo {

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

} // namespace odo
