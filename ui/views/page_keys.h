// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QEvent;

namespace odo {

/// For event() of a page on which Space plays: Space belongs to the button or list that has the focus before
/// that. True: the event was dealt with.
bool keepSpaceForFocus(QEvent &event);

} // namespace odo
