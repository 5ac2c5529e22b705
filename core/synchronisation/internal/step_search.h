// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/lag_course.h"
#include "core/synchronisation/internal/step_fit.h"

#include <optional>
#include <vector>

namespace odo {

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
