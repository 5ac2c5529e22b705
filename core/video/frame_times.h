// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"
#include "core/base/units.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace odo {

/// Where the times of a video's frames come from.
enum class TimeSource {
    Stamps, ///< each frame has its own
    Rate,   ///< none has; the file's header states an even frame rate
    Nowhere ///< the file states neither: only the frames' order is known, and their times are made up
};

/// How far apart the frames of a video are.
struct FrameSpacing
{
    /// the mean of all intervals within 10 % of their median; 0 of fewer than two frames
    Nanoseconds usual{0};
    bool isVariable = false; ///< some are not within that
};
FrameSpacing spacingOf(const std::vector<Nanoseconds> &frameTimes);

/// When the two fields of interlaced frames were taken: the second of each half-way to the next frame, or
/// half a usual interval behind where that is farther.
std::vector<Nanoseconds> fieldTimes(const std::vector<Nanoseconds> &frameTimes);

/// The shortest and the longest interval of a camera that takes its frames unevenly, as phones do: at least
/// one interval in twenty is off a whole number of the usual ones by more than a tenth. Nothing where they
/// are even, though some may be missing.
struct UnevenRate
{
    Nanoseconds shortest{0}, longest{0};
};
std::optional<UnevenRate> unevenRate(const std::vector<Nanoseconds> &frameTimes);

/// The same as a warning; empty where they are even.
Message unevenRateWords(const std::vector<Nanoseconds> &frameTimes);

/// A camera's clock was read: what it showed, and the times of this machine's steady clock between which it
/// did.
struct ClockReading
{
    Nanoseconds device{0}, before{0}, after{0};
};

/// A recorded frame's own times, from which the time it was taken is derived.
struct RawTime
{
    std::uint64_t sequence = 0; ///< the camera's count
    Nanoseconds device{0};      ///< by the camera's clock
    Nanoseconds arrival{0};     ///< by this machine's steady clock
};

/// The times of frames in the order of the file, and the readings of the camera's clock that came with
/// them.
struct RecordedTimes
{
    std::vector<RawTime> frames;
    std::vector<ClockReading> readings;
};

} // namespace odo
