// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <cstdint>
#include <vector>

namespace odo {

/// A camera's clock was read: what it showed, and the times of this machine's steady clock between which it
/// did.
struct ClockReading
{
    Nanoseconds device{0}, before{0}, after{0};
};

/// A recorded picture's own times, from which the time it was taken is derived.
struct RawTime
{
    std::uint64_t sequence = 0; ///< the camera's count
    Nanoseconds device{0};      ///< by the camera's clock
    Nanoseconds arrival{0};     ///< by this machine's steady clock
};

/// The times of pictures in the order of the file, and the readings of the camera's clock that came with
/// them.
struct RecordedTimes
{
    std::vector<RawTime> pictures;
    std::vector<ClockReading> readings;
};

} // namespace odo
