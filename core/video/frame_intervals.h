// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <cstdint>
#include <vector>

namespace odo {

/// So many intervals lie from `from` on, below `to`.
struct IntervalBin
{
    Nanoseconds from{0}, to{0};
    std::int64_t count = 0;
};

/// How a video's frames follow each other, by their times. Plain value.
struct FrameIntervals
{
    std::int64_t count = 0; ///< of the intervals; 0: fewer than two frames, and nothing else is set
    Nanoseconds usual{0}, shortest{0}, longest{0}; ///< usual: as of spacingOf
    double usualSigmaS = 0;                        ///< of the usual one: its intervals' scatter over √n
    /// Root mean square of how far intervals are from the usual one, of those that leave out no frame; σ = it
    /// over √2n
    double jitterS = 0, jitterSigmaS = 0;
    /// Intervals that are 1.5 usual ones and longer, and the frames that they leave out: of each the next
    /// whole number of usual ones, less one.
    std::int64_t gaps = 0, missing = 0;
    std::int64_t repeated = 0; ///< of no length: two frames have one time
    /// At most mostIntervalBins of equal width, a round number, from the shortest to the longest, and at
    /// least from 0.9 to 1.1 of the usual one; those that are longer than 4.5 usual ones are in `longer`.
    std::vector<IntervalBin> bins;
    std::int64_t longer = 0;
};
inline constexpr int mostIntervalBins = 48;

/// Pure; time and memory as the number of frames.
FrameIntervals frameIntervals(const std::vector<Nanoseconds> &frameTimes);

} // namespace odo
