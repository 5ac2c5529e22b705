// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QHelpEvent;
class QWidget;

namespace odo {

/// Shows words where the mouse rests on a widget, or takes away those of another place where there are none.
void showToolTip(const QHelpEvent &help, const QString &words, QWidget *widget);

} // namespace odo
