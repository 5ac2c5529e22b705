// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>

namespace odo {

/// The signs of a player's buttons.
enum class TransportSign { First, Play, Pause, Last };

/// Painted at whatever size and device pixel ratio it is shown, in one colour; lighter when disabled.
QIcon transportIcon(TransportSign sign, const QColor &colour);

} // namespace odo
