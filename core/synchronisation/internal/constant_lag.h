// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/clip_synchronisation.h"
#include "core/synchronisation/internal/clock_fit.h"

#include <optional>

namespace odo {

/// Why two tracks give no constant lag.
enum class NoLag { None, RarelyTogether, EveryOffset, TracksDiffer, BeyondRange, Repeats };

/// What comes of a search for one offset and one rate.
struct ConstantLag
{
    NoLag failure = NoLag::None;
    ClipOffset offset;   ///< where there is no failure
    Fit fit;             ///< of the offset; with the rate where it is taken
    double rivalS = 0;   ///< that fits as well, where the motion repeats itself
    double rateLeft = 0; ///< σ about 0 of one that is not significant, but may be there
    /// the tracks agree better at a rate that no clock has
    bool isRateBeyond = false;
};

/// Searches the range in half frames at equal rates, and refines by Gauss–Newton, then with the rate. Pure.
ConstantLag findConstantLag(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                            const OffsetRange &range);

} // namespace odo
