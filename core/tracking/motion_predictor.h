// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace odo {

/// Says where something will be that keeps its velocity. Luma pixels and seconds.
class MotionPredictor
{
public:
    /// Forgets the past: standing here now.
    void start(const Eigen::Vector2d &position, double timeS);
    /// A new measured position; the velocity follows by exponential smoothing. A time that does not advance
    /// only moves the position.
    void update(const Eigen::Vector2d &position, double timeS);
    /// A position that is known only coarsely: moves the prediction towards it, and hardly the velocity.
    void nudge(const Eigen::Vector2d &position, double timeS);
    /// After a quarter of a second without a measurement the prediction stands still: who is hidden does not
    /// run on for ever.
    Eigen::Vector2d at(double timeS) const;
    const Eigen::Vector2d &velocity() const { return m_velocity; }
    double lastTimeS() const { return m_timeS; }

private:
    Eigen::Vector2d m_position = Eigen::Vector2d::Zero(), m_velocity = Eigen::Vector2d::Zero();
    double m_timeS = 0;
};

} // namespace odo
