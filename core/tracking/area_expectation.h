// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace odo {

/// The area that a robot is expected to have in the next frame, luma pixels.
///
/// A robot that turns or comes nearer changes smoothly, at a rate that is followed; what changes at once has
/// merged with something or is partly hidden, and is believed only when it has stayed so for some frames. At
/// the border only growth tells of the whole.
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

} // namespace odo
