// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/frame_continuity.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace odo {

/// One robot's track, without positions that repeat the one before, and its noise.
struct CleanTrack
{
    FrameTrack positions;
    double noisePx = 0;                ///< of a coordinate, white
    std::vector<std::int64_t> repeats; ///< frames that were left out, in order
    std::vector<std::int64_t> marked;  ///< of these, those that the tracker knew by their image

    std::int64_t repeatsBefore(std::size_t index) const; ///< in the interval before a position
    /// Whether there are such, and all of them the image before, once more.
    bool isSameImageBefore(std::size_t index) const;
};

/// Pure; repeats are frames marked as such, and those in which a robot stands while it moves before and
/// after.
CleanTrack cleaned(const FrameTrack &track);

} // namespace odo
