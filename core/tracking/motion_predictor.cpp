// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/motion_predictor.h"

#include <algorithm>

namespace odo {

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

} // namespace odo
