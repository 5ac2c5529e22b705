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
    void start(double areaPx);
    void follow(double seenPx, bool atBorder);
    double px() const { return m_px; }

private:
    double m_px = 0;
    double m_lastPx = 1;    ///< seen in the last frame
    double m_rate = 0;      ///< of its logarithm, a frame
    int m_steadyFrames = 0; ///< during which the area seen hardly changed
};

} // namespace odo
