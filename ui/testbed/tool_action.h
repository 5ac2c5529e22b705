// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAction;
class QObject;

namespace odo {

/// An action that stands in the menu by its long words, and on a button beneath a table by its short ones.
QAction *toolAction(const QString &icon, const QString &text, const QString &shortText, const QString &tip,
                    QObject *parent);

} // namespace odo
