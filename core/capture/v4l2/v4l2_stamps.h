// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

#include <cstdint>
#include <optional>

namespace odo {

/// What a driver says of a buffer.
struct V4l2BufferStamp
{
    std::uint32_t sequence = 0; ///< wraps
    std::uint64_t time = 0;     ///< nanoseconds; wraps
    bool isMonotonic = false;   ///< of this machine's steady clock (steadyNow()), so the driver says
};

/// Makes of drivers' counts and times what CapturedFrame has: counts that rise and times that go on, whatever
/// wraps, repeats, jumps or begins anew. Not thread-safe.
class V4l2Stamps
{
public:
    struct Stamp
    {
        std::uint64_t sequence = 0;
        Nanoseconds time{0};
        std::optional<ClockReading> clock; ///< where the driver's times are this machine's
    };
    /// Of every buffer, damaged ones too. arrival: by the steady clock.
    Stamp next(const V4l2BufferStamp &buffer, Nanoseconds arrival);
    /// The stream begins anew: what would have come meanwhile counts as lost.
    void beginAnew(double framesPerSecond);

private:
    void count(std::uint32_t sequence, Nanoseconds arrival);
    void advance(std::uint64_t time, Nanoseconds arrival);

    bool m_first = true;
    double m_lostRate = 0; ///< frames a second that were lost until now; 0: the stream has gone on
    std::uint32_t m_lastSequence = 0;
    std::uint64_t m_lastTime = 0, m_repeated = 0;
    Nanoseconds m_lastArrival{0};
    Stamp m_stamp;
    bool m_isTrusted = true; ///< no time was in the future or jumped
};

} // namespace odo
