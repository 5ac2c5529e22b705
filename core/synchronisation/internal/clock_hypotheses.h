// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/step_search.h"

#include <vector>

namespace odo {

/// A relation of two clocks, and how well it explains their tracks.
struct ClockHypothesis
{
    SteppedClocks clocks = {};
    double against = 0;    ///< it, beside what clockLikelihood knows of
    double likelihood = 0; ///< its logarithm, less what speaks against such a relation beforehand
};

/// A fitted relation of one lag and one rate among those with steps at its rate, the likeliest first. Pure.
std::vector<ClockHypothesis> hypothesesAbout(const std::vector<TimedPosition> &first,
                                             const std::vector<TimedPosition> &second, const LagRange &range,
                                             const Fit &fit);

/// The relations that explain two tracks, the likeliest first: at any rate of ±2 % or one that a wrong label
/// makes, each with the steps that the tracks need at it; and those known already. Pure; long.
std::vector<ClockHypothesis> clockHypotheses(const std::vector<TimedPosition> &first,
                                             const std::vector<TimedPosition> &second, const LagRange &range,
                                             std::vector<ClockHypothesis> known);

} // namespace odo
