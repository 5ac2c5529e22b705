// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

namespace odo {

/// A camera's time stamps on one scale, zero at its first frame, that continues when the camera was away and
/// its clock restarts: then this machine's clock gives the time between. Not thread-safe.
class CameraTimeScale
{
public:
    /// The camera was reconnected.
    void interrupt() { m_interrupted = true; }

    /// False where a frame's stamp does not follow that of the one before: the clock was reset, and
    /// should be read now. A frame may be late by any time; an early one indicates another clock.
    bool goesOn(Nanoseconds stamp, Nanoseconds arrival) const
    {
        return !m_last || follows({stamp, arrival, false});
    }

    /// The time of a frame; they come in order. reading: of the camera's clock, within some seconds of the
    /// frame.
    Nanoseconds location(Nanoseconds stamp, Nanoseconds arrival, const std::optional<ClockReading> &reading);

    /// Any time of the camera's clock; after the first frame.
    Nanoseconds onScale(Nanoseconds device) const { return device - m_zero; }

private:
    struct FrameStamp
    {
        Nanoseconds stamp;
        Nanoseconds taken; ///< by this machine's clock: no later than this
        bool isRead;       ///< exactly then, by a reading of the camera's clock
    };
    std::optional<Nanoseconds> takenBy(const ClockReading &reading, Nanoseconds stamp,
                                       Nanoseconds arrival) const;
    bool follows(const FrameStamp &frame) const;

    std::optional<FrameStamp> m_last;
    Nanoseconds m_zero{0}; ///< of the scale, by the camera's clock
    bool m_interrupted = false;
};

/// Numbers frames without wrapping, from a camera's numbers of 16 bits that go from 65535 to 1, or of 64. Not
/// thread-safe.
class FrameNumbering
{
public:
    /// Gaps in the camera's numbers are gaps here.
    std::uint64_t number(std::uint64_t cameraNumber);
    /// The camera was reconnected and its count restarted; meanwhile it would have taken so many.
    void interrupt(std::uint64_t missed);

private:
    std::optional<std::uint64_t> m_last; ///< the camera's; none: begins
    std::uint64_t m_next = 0;
};

} // namespace odo
