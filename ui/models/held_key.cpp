// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/held_key.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <algorithm>

namespace odo {

HeldKey::HeldKey(const QAction &action, QObject *parent) : QObject(parent), m_action(action)
{
    if (QCoreApplication *application = QCoreApplication::instance())
        application->installEventFilter(this); // a shortcut's key goes to no widget
}

bool HeldKey::isItsKey(int key) const
{
    return std::ranges::any_of(m_action.shortcuts(), [key](const QKeySequence &keys) { return keys.count() == 1 && keys[0].key() == key; });
}

bool HeldKey::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride: // comes before the shortcut runs
    case QEvent::KeyPress:
        m_isHeld |= isItsKey(static_cast<QKeyEvent *>(event)->key());
        break;
    case QEvent::KeyRelease:
        // A key that is held repeats as releases and presses.
        if (const auto *key = static_cast<QKeyEvent *>(event); !key->isAutoRepeat() && isItsKey(key->key()))
            m_isHeld = false;
        break;
    case QEvent::ApplicationStateChange:
    case QEvent::WindowDeactivate: // its release would go elsewhere
        m_isHeld = false;
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace odo
