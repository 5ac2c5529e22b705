// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/frame_continuity.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace odo {

/// A video that was converted to a higher frame rate by repeating frames, as 25 frames/s to 30: one frame in
/// so many repeats the one before, and the others are stamped too early or too late by up to most of a frame.
struct FrameConversion
{
    std::int64_t every = 0;
    std::int64_t first = 0; ///< the first frame that repeats one
    bool isTimed = false;   ///< the times are those of convertedTimes already
};

/// From the frames in which robots stand while they move before and after: nearly all at equal distances, and
/// at least every second one where it is expected. As findFrameSteps otherwise; pure, any thread.
std::optional<FrameConversion> findConversion(const std::vector<FrameTrack> &tracks,
                                              const std::vector<Nanoseconds> &frameTimes);

/// When the frames were taken: evenly from each that follows a repeated one to the next such. Repeated frames
/// lie between their neighbours. The first stays at 0.
std::vector<Nanoseconds> convertedTimes(const FrameConversion &conversion,
                                        const std::vector<Nanoseconds> &frameTimes);

} // namespace odo
