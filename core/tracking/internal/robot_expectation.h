// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace odo {

/// The area that a robot is expected to have in the next frame, luma pixels.
///
/// A robot that turns or comes nearer changes smoothly, at a rate that is followed; what changes at once has
/// merged with something or is partly hidden, and is believed only when it has stayed so for some frames. At
/// the border only growth is informative.
class AreaExpectation
{
public:
    /// Seen for the first time.
    void start(double areaPx);
    /// Not seen: it may have gone behind something.
    void lose();
    /// Seen again after that: perhaps not yet all of it.
    void startAgain(double areaPx);
    void follow(double seenPx, bool atBorder);
    double px() const { return m_px; }
    /// Lost, or just seen again: the largest area it had of late, for one that goes behind something shrinks
    /// smoothly to a sliver, and comes out bit by bit or whole. Else as px().
    double wholePx() const { return m_mayBeHidden ? m_largestPx : m_px; }
    /// How many times larger (or, below one, smaller) an area is than px(), wholePx() and all between.
    double ratioToLikely(double areaPx) const;
    /// How far it is from the nearer of the two, of the logarithm.
    double offInLn(double areaPx) const;

private:
    void expect(double seenPx, bool atBorder);

    double m_px = 0;
    double m_largestPx = 0; ///< of late
    bool m_mayBeHidden = false;
    double m_lastPx = 1;    ///< seen in the last frame
    double m_rate = 0;      ///< of its logarithm, a frame
    int m_steadyFrames = 0; ///< during which the area seen hardly changed
};

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

/// exp(−x²/2): how well something agrees that lies x standard deviations away.
double bellOf(double x);

/// 0 to 1: how much a region of these second moments and this area looks like one solid piece. An ellipse
/// fills the ellipse of its moments wholly, a rectangle to 95 %; branches, rings and scattered samples much
/// less; tape is too long.
double compactness(const Eigen::Matrix2d &covariance, double area);

/// 0 to 1: how plausible it is that a robot fills this fraction of the frame.
double sizeLikelihood(double fractionOfImage);

} // namespace odo
