// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/person.h"

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

} // namespace odo::test
