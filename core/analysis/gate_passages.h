// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"

#include <vector>

namespace odo {

/// When the robot's reference point passes the gates in their direction, in order of time. Between two frames
/// the smoothed position is the cubic through both positions and velocities; the moment is where it meets the
/// gate's line, between the ends (which count as the gate). σ_t = σ⊥ / v⊥, across the gate, and where the
/// speed changes meanwhile half the time from when the track would meet the line if it lay by σ⊥ further on
/// to when by σ⊥ less (or half of that at 2 σ⊥, or a third at 3 σ⊥, if it is more). Noise does not count
/// twice: a robot has passed when it was before the line by six σ of the track's own noise and then is past
/// it by as much; where it goes to and fro between, the middle of the first and last crossing is taken. A
/// robot that starts in the gate has not passed it, nor one that came to the other side in a gap of the
/// profile.
std::vector<GatePassage> findPassages(const std::vector<Gate> &gates, const std::vector<Sample> &samples,
                                      const std::vector<ProfilePoint> &points);

/// A part of a lap, up to a gate.
struct Sector
{
    std::string gate; ///< that ends it
    double timeS = 0, sigmaS = 0;
};

/// A whole run from the start to the finish, which may be one gate.
struct Lap
{
    Nanoseconds start{0}; ///< since the first view's first frame
    double timeS = 0, sigmaS = 0;
    std::vector<Sector> sectors; ///< more than one where splits were passed
};

/// The whole runs in passages that are in order of time. A run begins with the first passage of the start;
/// of each split its first passage in the run counts. σ: both passages' own parts are independent, and so are
/// the calibration's at two gates; at one gate the latter is the same shift at each passage, of which the
/// difference of speeds leaves a part.
std::vector<Lap> lapsOf(const std::vector<GatePassage> &passages);

} // namespace odo
