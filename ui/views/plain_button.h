// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QPushButton;

namespace odo {

/// A button of a dialog that never takes the Enter key, which belongs to the default button; not before it is
/// made the default one itself.
QPushButton *plainButton(const QString &text);

} // namespace odo
