// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QString>

namespace odo {

/// What went into figures, in words that fit a line.

/// "Kalman/RTS, noise from the data"
QString smootherText(Smoother smoother);
/// How a view was put in step with the first one: "in step to 1.2 ms, found from the motion; begun 3.0 ms later".
QString stepText(const RecordingRecord &view);
/// How far apart the pictures of a camera with an uneven rate are: "9 to 46 ms apart"; empty where the rate is even.
QString unevenText(const RecordingRecord &view);

} // namespace odo
