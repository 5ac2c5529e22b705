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

} // namespace odo
