// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/v4l2_stamps.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds resolution = 1us; // of the time that drivers tell
constexpr Nanoseconds largestDelay =
    1s; // from taking to delivery; beyond it a time is not of this machine's clock

/// Of times that wrap.
Nanoseconds between(std::uint64_t earlier, std::uint64_t later)
{
    return Nanoseconds(static_cast<std::int64_t>(later - earlier));
}

} // namespace

void V4l2Stamps::beginAnew(double framesPerSecond)
{
    if (!m_first)
        m_lostRate = framesPerSecond;
}

/// A number may repeat (a driver that rounds its times); the one that it leaves out later is then no loss.
void V4l2Stamps::count(std::uint32_t sequence, Nanoseconds arrival)
{
    const auto step = static_cast<std::int32_t>(sequence - m_lastSequence);
    m_lastSequence = sequence;
    if (m_first)
        return;
    if (m_lostRate > 0) {
        const double missed = toSeconds(arrival - m_lastArrival) * m_lostRate;
        m_stamp.sequence += static_cast<std::uint64_t>(std::max(1L, std::lround(missed)));
        m_repeated = 0;
    } else if (step <= 0) {
        m_repeated += step == 0;
        ++m_stamp.sequence;
    } else {
        const std::uint64_t repaid =
            std::min<std::uint64_t>(static_cast<std::uint64_t>(step) - 1, m_repeated);
        m_repeated -= repaid;
        m_stamp.sequence += static_cast<std::uint64_t>(step) - repaid;
    }
}

/// By the driver's times, unless they contradict the arrivals: then the arrivals bridge the jump.
void V4l2Stamps::advance(std::uint64_t time, Nanoseconds arrival)
{
    const Nanoseconds step = between(m_lastTime, time), arrived = arrival - m_lastArrival;
    m_lastTime = time;
    if (m_first)
        return;
    const bool sound = step > 0ns && std::chrono::abs(step - arrived) < largestDelay;
    m_isTrusted = m_isTrusted && sound;
    m_stamp.time += sound ? step : std::max(arrived, resolution);
}

V4l2Stamps::Stamp V4l2Stamps::next(const V4l2BufferStamp &buffer, Nanoseconds arrival)
{
    count(buffer.sequence, arrival);
    advance(buffer.time, arrival);
    m_first = false;
    m_lostRate = 0;
    m_lastArrival = arrival;
    const Nanoseconds age = between(buffer.time, static_cast<std::uint64_t>(arrival.count()));
    m_isTrusted = m_isTrusted && buffer.isMonotonic && age >= 0ns && age < largestDelay;
    m_stamp.clock.reset();
    if (m_isTrusted) {
        const Nanoseconds host(static_cast<std::int64_t>(buffer.time));
        m_stamp.clock = {m_stamp.time, host, host + resolution};
    }
    return m_stamp;
}

} // namespace odo
