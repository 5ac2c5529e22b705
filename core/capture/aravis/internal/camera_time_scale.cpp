// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/internal/camera_time_scale.h"

#include "core/capture/clock_map.h"

#include <algorithm>

namespace odo {

namespace {

using namespace std::chrono_literals;

// How far a clock that goes on may be from where it is expected, but for how fast it runs.
constexpr Nanoseconds earliest = 1s, earliestAfterInterruption = largestClockJump;
constexpr Nanoseconds usuallyLatest = 1s, latestBesideReading = 10s;
constexpr std::uint64_t lastOf16Bits = 0xffff;
constexpr std::uint64_t largestGap = 30000; // of 16-bit numbers; more is a count that restarted

} // namespace

bool CameraTimeScale::follows(const FrameStamp &frame) const
{
    const Nanoseconds step = frame.stamp - m_last->stamp, passed = frame.taken - m_last->taken;
    if (step <= 0ns)
        return false;
    const Nanoseconds drift = fromSeconds(fastestClockRate * toSeconds(step)), early = step - passed;
    const Nanoseconds tolerance = m_interrupted ? earliestAfterInterruption : earliest;
    // A restarted clock matches a late frame's time only by chance.
    const Nanoseconds latest = frame.isRead    ? tolerance
                               : m_interrupted ? usuallyLatest
                                               : Nanoseconds::max() / 2;
    return early <= tolerance + drift && -early <= latest + drift;
}

/// nullopt where the reading, or the frame, may predate a reset of the clock. Where nothing seems to
/// have happened, the frame's lateness shows this; otherwise the clock is read after it has arrived.
std::optional<Nanoseconds> CameraTimeScale::takenBy(const ClockReading &reading, Nanoseconds stamp,
                                                    Nanoseconds arrival) const
{
    const Nanoseconds taken =
        reading.before + (reading.after - reading.before) / 2 + (stamp - reading.device);
    const bool isFresh = reading.before >= arrival && (m_interrupted || !goesOn(stamp, arrival));
    const Nanoseconds late = arrival - taken;
    return late > -earliest && late < (isFresh ? latestBesideReading : usuallyLatest) ? std::optional(taken)
                                                                                      : std::nullopt;
}

Nanoseconds CameraTimeScale::location(Nanoseconds stamp, Nanoseconds arrival,
                                      const std::optional<ClockReading> &reading)
{
    const auto taken = reading ? takenBy(*reading, stamp, arrival) : std::nullopt;
    FrameStamp frame{stamp, taken.value_or(arrival), taken.has_value()};
    if (!m_last) {
        m_zero = stamp;
    } else if (!follows(frame)) {
        m_zero = stamp - (onScale(m_last->stamp) + std::max(frame.taken - m_last->taken, Nanoseconds(1)));
    } else if (!frame.isRead) {
        const Nanoseconds step = stamp - m_last->stamp;
        frame.taken =
            std::min(arrival, m_last->taken + step + fromSeconds(fastestClockRate * toSeconds(step)));
    }
    m_last = frame;
    m_interrupted = false;
    return onScale(stamp);
}

std::uint64_t FrameNumbering::number(std::uint64_t cameraNumber)
{
    if (m_last) {
        const bool wide = cameraNumber > lastOf16Bits || *m_last > lastOf16Bits;
        const std::uint64_t step =
            wide ? cameraNumber - *m_last : (cameraNumber + lastOf16Bits - *m_last) % lastOf16Bits;
        if (step > 1 && step < largestGap)
            m_next += step - 1;
    }
    m_last = cameraNumber;
    return m_next++;
}

void FrameNumbering::interrupt(std::uint64_t missed)
{
    m_last.reset();
    m_next += missed;
}

} // namespace odo
