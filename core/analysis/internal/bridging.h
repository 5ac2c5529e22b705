// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/motion_stretches.h"

#include <vector>

namespace odo {

/// What the robot is able to do, by what was measured of this run: its top speed, and its strongest
/// acceleration; at least that with which it comes to its top speed in half a second.
struct RobotLimits
{
    double speedMps = 0, accelMps2 = 0;
};
RobotLimits limitsOf(const std::vector<RunInstant> &instants);

/// What the robot can have done in a bridged stretch. It left one position with one velocity and came to
/// another with another, within its limits.
struct Bridge
{
    BridgedStretch stretch;
    double fromS = 0, toS = 0;
    /// Of its length. A course other than the cubic leaves it and comes back within the acceleration, so it
    /// is this far apart from it at most: a quarter of the peak of the speed across, times a quarter of the
    /// time. It is longer by what it goes aside (v⊥²/2v) and where it takes the curve wider, and shorter
    /// where it cuts it, down to the straight line. The largest of these is taken as two σ.
    double sigmaLengthM = 0;
    bool mayHaveStopped = false; ///< it could come so far with a stop on its way
};
/// Of a robot that rests before and after it in one place it is assumed that it stood: no uncertainty.
std::vector<Bridge> bridgesOf(const std::vector<RunInstant> &instants);

/// The mean speed of the whole run from its measured part: as if the robot went straight through its gaps,
/// or with its top speed.
struct SpeedRange
{
    double leastMps = 0, mostMps = 0;
};
/// pathM: of the measured part; durationS: from the first to the last motion, gaps between them included.
SpeedRange meanSpeedRange(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions,
                          double pathM, double durationS);

/// Whether the run may have begun earlier or ended later than its motions: it moves next to a gap, or was
/// elsewhere after one.
bool mayBeLonger(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions);

/// σ of a moment that lies within a bridged stretch, at which the robot starts (step 1) or stops (step −1);
/// 0: it does not.
double sigmaOfBridgedMoment(const std::vector<Bridge> &bridges, double timeS, int step);

} // namespace odo
