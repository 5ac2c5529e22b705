// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace odo {

class CommandKeys;

/// The list of keys, and what this program is. Not modal for the first, which one wants to read while
/// working.
void showKeys(const CommandKeys &keys, QWidget &window);
void showAbout(QWidget &window);

} // namespace odo
