// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/recording_outcome.h"

namespace odo {

/// When recorded pictures were taken, by this machine's steady clock.
struct DerivedTimes
{
    std::vector<Nanoseconds> taken; ///< one for each picture, increasing
    double sigmaS = 0;              ///< of all of them alike
};

/// Derives from the raw times of a recording when each picture was taken: the camera's clock as ClockMap
/// learns it, with what came before and after. Pure.
DerivedTimes deriveTimes(const RecordedTimes &times);

} // namespace odo
