// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/steady_now.h"

namespace odo::test {

/// A camera's own clock: begins anywhere, runs fast by some ppm, counts in ticks. The truth that clock maps
/// are measured against.
class SimulatedClock
{
public:
    SimulatedClock(double offsetS, double ppm, std::uint64_t ticksPerSecond, Nanoseconds beginning)
        : m_offsetS(offsetS), m_rate(1 + ppm * 1e-6), m_ticksPerSecond(ticksPerSecond), m_beginning(beginning)
    {
    }

    std::uint64_t ticks(Nanoseconds host) const
    {
        const double shownS = m_offsetS + toSeconds(host - m_beginning) * m_rate;
        const auto wholeS = static_cast<std::uint64_t>(shownS);
        return wholeS * m_ticksPerSecond + static_cast<std::uint64_t>((shownS - static_cast<double>(wholeS)) *
                                                                      static_cast<double>(m_ticksPerSecond));
    }
    /// As long as the camera takes for what it thinks to be this.
    Nanoseconds hostSpan(double cameraS) const { return fromSeconds(cameraS / m_rate); }
    /// It shows 0 from now on.
    void reset(Nanoseconds host)
    {
        m_offsetS = 0;
        m_beginning = host;
    }

private:
    double m_offsetS, m_rate;
    std::uint64_t m_ticksPerSecond;
    Nanoseconds m_beginning;
};

} // namespace odo::test
