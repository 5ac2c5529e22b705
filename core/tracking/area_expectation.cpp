// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/area_expectation.h"

#include "core/tracking/region_score.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double steadyChange = 0.025; ///< of the logarithm of the area, from one frame to the next
constexpr int steadyEnough = 8;
constexpr double forgottenPerFrame = 0.01; ///< of the logarithm of the largest area
constexpr double leastOfTheWhole = 0.9;    ///< of the largest area

} // namespace

void AreaExpectation::start(double areaPx)
{
    m_largestPx = 0;
    m_mayBeHidden = false;
    startAgain(areaPx);
}

void AreaExpectation::startAgain(double areaPx)
{
    m_px = m_lastPx = areaPx;
    m_rate = 0;
    m_steadyFrames = 0;
    m_largestPx = std::max(m_largestPx, areaPx);
}

void AreaExpectation::lose()
{
    m_mayBeHidden = true;
}

double AreaExpectation::ratioToLikely(double areaPx) const
{
    return areaPx / std::clamp(areaPx, m_px, wholePx());
}

double AreaExpectation::offInLn(double areaPx) const
{
    return std::min(std::abs(std::log(areaPx / m_px)), std::abs(std::log(areaPx / wholePx())));
}

void AreaExpectation::follow(double seenPx, bool atBorder)
{
    expect(seenPx, atBorder);
    m_largestPx = std::max(m_px, m_largestPx * std::exp(-forgottenPerFrame));
    if (m_px > leastOfTheWhole * m_largestPx || m_steadyFrames >= steadyEnough)
        m_mayBeHidden = false;
}

void AreaExpectation::expect(double seenPx, bool atBorder)
{
    if (atBorder) {
        m_px = std::max(m_px, seenPx);
        m_rate = 0;
        return;
    }
    if (m_mayBeHidden && seenPx > leastOfTheWhole * m_largestPx && seenPx < m_largestPx / leastOfTheWhole) {
        startAgain(seenPx);
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
