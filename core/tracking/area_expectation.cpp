// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/area_expectation.h"

#include "core/tracking/region_score.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double steadyChange = 0.025; ///< of the logarithm of the area, from one frame to the next
constexpr int steadyEnough = 8;

} // namespace

void AreaExpectation::start(double areaPx)
{
    m_px = m_lastPx = areaPx;
    m_rate = 0;
    m_steadyFrames = 0;
}

void AreaExpectation::follow(double seenPx, bool atBorder)
{
    if (atBorder) {
        m_px = std::max(m_px, seenPx);
        m_rate = 0;
        return;
    }
    const double change = std::log(seenPx / m_lastPx);
    m_lastPx = seenPx;
    m_steadyFrames = std::abs(change) < steadyChange ? m_steadyFrames + 1 : 0;
    const double surprise = std::log(seenPx / m_px);
    const double trust = m_steadyFrames >= steadyEnough ? 1 : bellOf(surprise / 0.13);
    // Without trust the rate dies away, so that the expectation never runs off by itself.
    m_rate = (0.5 + 0.5 * trust) * std::clamp(m_rate + 0.3 * trust * surprise, -0.15, 0.15);
    m_px *= std::exp((0.03 + 0.47 * trust) * surprise + m_rate);
}

} // namespace odo
