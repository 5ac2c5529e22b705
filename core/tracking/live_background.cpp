// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/live_background.h"

namespace odo {

namespace {

constexpr Nanoseconds interval = std::chrono::milliseconds(100); // of the frames that are looked at
constexpr std::int64_t mostBetween = 50;                         // moving frames from one learning to the next

} // namespace

std::optional<Background> LiveBackground::add(const Frame &frame)
{
    if (m_lastLook != Nanoseconds::min() && frame.time - m_lastLook < interval)
        return std::nullopt;
    m_lastLook = frame.time;
    m_learner.add(frame);
    if (m_learner.movingFrames() < m_next)
        return std::nullopt;
    m_next += std::min(m_next / 2, mostBetween);
    return m_learner.learned();
}

} // namespace odo
