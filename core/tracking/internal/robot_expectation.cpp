// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/robot_expectation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

namespace {
constexpr double gain = 0.6;
constexpr double coarseGain = 0.4, coarseVelocityGain = 0.08;
constexpr double longestCoastS = 0.25;
} // namespace

void MotionPredictor::start(const Eigen::Vector2d &position, double timeS)
{
    m_position = position;
    m_velocity.setZero();
    m_timeS = timeS;
}

void MotionPredictor::update(const Eigen::Vector2d &position, double timeS)
{
    if (timeS > m_timeS)
        m_velocity += gain * ((position - m_position) / (timeS - m_timeS) - m_velocity);
    m_position = position;
    m_timeS = timeS;
}

void MotionPredictor::nudge(const Eigen::Vector2d &position, double timeS)
{
    const Eigen::Vector2d predicted = at(timeS), off = position - predicted;
    if (timeS > m_timeS)
        m_velocity += coarseVelocityGain * off / (timeS - m_timeS);
    m_position = predicted + coarseGain * off;
    m_timeS = std::max(m_timeS, timeS);
}

Eigen::Vector2d MotionPredictor::at(double timeS) const
{
    return m_position + m_velocity * std::clamp(timeS - m_timeS, 0.0, longestCoastS);
}

double bellOf(double x)
{
    return std::exp(-0.5 * x * x);
}

double compactness(const Eigen::Matrix2d &covariance, double area)
{
    const double determinant = covariance.determinant();
    if (determinant <= 0)
        return 0;
    const double fill = area / (4 * std::numbers::pi * std::sqrt(determinant));
    const double solid = std::clamp((fill - 0.5) / 0.35, 0.0, 1.0);
    const double halfTrace = covariance.trace() / 2;
    const double spread = std::sqrt(std::max(0.0, halfTrace * halfTrace - determinant));
    const double longOverShort = std::sqrt((halfTrace + spread) / std::max(halfTrace - spread, 1e-9));
    return solid * bellOf(std::max(0.0, longOverShort - 4.0) / 1.5);
}

double sizeLikelihood(double fractionOfImage)
{
    constexpr double small = 1e-4, large = 0.2;
    return fractionOfImage / (fractionOfImage + small) * bellOf(std::max(0.0, fractionOfImage - large) / 0.1);
}

} // namespace odo
