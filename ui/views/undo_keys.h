// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/own_changes.h"

#include <functional>

class QWidget;

namespace odo {

/// Gives a dialog the keys by which what it changed is taken back (Ctrl+Z) and made again (Ctrl+Shift+Z);
/// tell is handed what came of it. The changes must outlive the dialog's keys. GUI thread.
void addUndoKeys(QWidget &dialog, OwnChanges &changes,
                 const std::function<void(const Result<QString> &)> &tell);

} // namespace odo
