// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/clock_fit.h"
#include "core/synchronisation/internal/step_finder.h"

#include <vector>

namespace odo {

/// A relation of two clocks whose stamps may be off from some moments on.
struct SteppedClocks
{
    ClockGuess clock; ///< of the repaired tracks
    ClockRepair first, second;
    double variance = 0;    ///< m², of what remains
    double correlatedS = 0; ///< over which it is alike
    double lagSigmaS = 0;   ///< of the lag where it is known worst
    std::size_t pairs = 0;
    std::vector<LagPiece> pieces = {}; ///< that it was made from, with their fitted lags

    std::size_t steps() const { return first.steps.size() + second.steps.size(); }
};

/// Gauss–Newton of offset, rate and the steps' lengths, the moments of the steps as they are. The steps get
/// their lengths and σ. Pure.
SteppedClocks fittedSteps(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                          ClockGuess clock, std::vector<FoundStep> &steps, bool withRate);

/// Moves the steps one by one, by 4 to 16 frames at a time, as long as less remains with lengths fitted anew
/// (coordinate descent). false: none was moved. The pieces stay as they are. Pure.
bool moveSteps(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
               SteppedClocks &clocks, bool withRate);

} // namespace odo
