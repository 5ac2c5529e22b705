// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAction;
class QPushButton;

namespace odo {

/// A button that triggers an action and is enabled with it; text: with its mnemonic, if it is to have one. In a dialog it
/// never takes the Enter key, which belongs to the default button.
QPushButton *actionButton(QAction *action, const QString &text);

} // namespace odo
