// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace odo {

/// Does work on the window's thread, that of the QApplication, and waits until it is done: at once where that
/// is the caller's, else between two events. For what Qt does there alone, such as charts; keep it short.
/// Where the caller is to end (CancelScope) it throws WorkCancelled instead of waiting on, and the work may
/// still be done later or not at all: work must own all that it touches. Any thread.
void onWindowThread(std::function<void()> work);

} // namespace odo
