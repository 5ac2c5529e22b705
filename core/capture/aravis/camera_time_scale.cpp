// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/camera_time_scale.h"

#include <algorithm>

namespace odo {

namespace {

using namespace std::chrono_literals;

// A clock that goes on is found where it is expected, but for how late pictures come and how fast it runs.
constexpr Nanoseconds latest = 1s, latestAfterInterruption = 50ms;
constexpr double fastestClock = 500e-6;
constexpr std::uint64_t lastOf16Bits = 0xffff;
constexpr std::uint64_t largestGap = 30000; // of numbers of 16 bits; more is a count that began anew

} // namespace

/// Since the last picture, by this machine's clock.
Nanoseconds CameraTimeScale::passedBefore(const Picture &picture) const
{
    return picture.host && m_last->host ? *picture.host - *m_last->host : picture.arrival - m_last->arrival;
}

bool CameraTimeScale::follows(const Picture &picture) const
{
    const Nanoseconds passed = passedBefore(picture);
    const Nanoseconds tolerance =
        (m_interrupted ? latestAfterInterruption : latest) + fromSeconds(fastestClock * toSeconds(passed));
    return picture.stamp > m_last->stamp &&
           std::chrono::abs(picture.stamp - m_last->stamp - passed) <= tolerance;
}

Nanoseconds CameraTimeScale::place(Nanoseconds stamp, Nanoseconds arrival,
                                   const std::optional<ClockReading> &reading)
{
    Picture picture{stamp, arrival, std::nullopt};
    if (reading) {
        const Nanoseconds host =
            reading->before + (reading->after - reading->before) / 2 + (stamp - reading->device);
        if (std::chrono::abs(host - arrival) < latest) // else it is one of before the clock was set
            picture.host = host;
    }
    if (!m_last)
        m_zero = stamp;
    else if (!follows(picture))
        m_zero = stamp - (onScale(m_last->stamp) + std::max(passedBefore(picture), Nanoseconds(1)));
    m_last = picture;
    m_interrupted = false;
    return onScale(stamp);
}

std::uint64_t PictureNumbering::number(std::uint64_t cameraNumber)
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

void PictureNumbering::interrupt(std::uint64_t missed)
{
    m_last.reset();
    m_next += missed;
}

} // namespace odo
