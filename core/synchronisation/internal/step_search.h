// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/clock_fit.h"
#include "core/synchronisation/internal/lag_course.h"

#include <optional>
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

/// The logarithm of the likelihood of a relation that leaves so much of independent moments, less what speaks
/// against it beforehand.
double clockLikelihood(const SteppedClocks &clocks, double independent);

/// What speaks against each second that only one view is said to have seen.
inline constexpr double againstUnseenS = 10;

/// How many independent moments a relation was compared at.
double independentMoments(const SteppedClocks &clocks, double frameS);

/// Makes steps of the jumps of a lag and fits them together with offset and rate. Where the lag grows, the
/// second view lost frames or the first one doubled some, and where it falls the other way round: which of
/// both shows in how far the robot got meanwhile. A jump at a gap of a view is one of that view's clock.
/// Steps of less than a frame are left out. nullopt: the course has no piece. Pure.
std::optional<SteppedClocks> steppedClocks(const std::vector<TimedPosition> &first,
                                           const std::vector<TimedPosition> &second, const LagCourse &course,
                                           bool withRate);

/// Adds steps where what remains shows them, one by one, and takes off those that explain too little. The
/// best relation comes first, then the others that were tried. Pure.
std::vector<SteppedClocks> withBetterSteps(const std::vector<TimedPosition> &first,
                                           const std::vector<TimedPosition> &second, SteppedClocks clocks,
                                           double noiseM, bool withRate);

} // namespace odo
