// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/person.h"

#include <functional>

class QAction;

namespace odo {
class MainWindow;
}

namespace odo::test {

/// Before the first window of a test program: settings of its own, which are empty, and file dialogs that a
/// Person can answer.
void beginWithoutSettings();

/// Waits until no job runs and everything that belongs to the page on screen is there.
void waitFor(const MainWindow &window);

/// Triggers an action of the window, answers its dialogs, and waits for the job that may follow.
void run(MainWindow &window, QAction *action, const QList<Answer> &answers);

/// Opens the dialogs of all commands that can be called in all modes, one after the other, has a look at each
/// (but Qt's own for files), and dismisses it. Gives how many there were.
int lookAtDialogs(MainWindow &window,
                  const std::function<void(const QAction &command, QDialog &dialog)> &look);

/// A row for each mode of the window, with its number in the column "mode".
void addModeRows();

/// Warns of each in a line of its own; gives how many there are.
qsizetype told(const QStringList &found);

} // namespace odo::test
