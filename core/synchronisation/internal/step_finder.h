// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/lag_course.h"

#include <vector>

namespace odo {

/// A step of one of the views.
struct FoundStep
{
    bool inFirst = false;
    ClockStep step;

    /// What the lag changes by with each second that the step is longer.
    double sign() const { return inFirst ? -1 : 1; }
};

/// The step behind the jump of a lag from one piece to the next: when it was, as exactly as these lags show,
/// and of which view's clock it is. rate: of the second clock. noiseM: of a coordinate. Pure.
FoundStep stepBetween(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                      const LagPiece &before, const LagPiece &after, double rate, double noiseM);

} // namespace odo
