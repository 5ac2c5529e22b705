// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace odo {

/// One time of a robot's turning, in order of time: with a measured heading, without steps of a whole turn,
/// or with none (to be bridged). Radians, seconds.
struct TurnNode
{
    double timeS = 0;
    bool measured = false;
    double radians = 0, variance = 0;
};

struct TurnEstimate
{
    double radians = 0, sigmaRad = 0;
    double rateRadps = 0, sigmaRateRadps = 0;
};

/// Kalman filter and Rauch–Tung–Striebel smoother of a heading with a white angular acceleration, whose
/// density differs from step to step: a robot stands, begins to spin within a frame, spins evenly. It is
/// Student's t with one degree of freedom over five steps, and so are the measurements with eight, both by
/// expectation maximisation (Lange, Little, Taylor 1989): neither a sudden spin nor an outlier spoils the
/// rest. A factor on all variances is estimated too (turnNoiseScale, or more where the curve shows it).
/// Segments share what is learnt; each begins with a measurement, and has five or more. One estimate a node.
/// Pure.
std::vector<std::vector<TurnEstimate>> smoothTurning(const std::vector<std::vector<TurnNode>> &segments);

/// By how much the variances must be multiplied to be those of the scatter: from the fourth divided
/// differences of measurements in a row, by their median, which neither an even motion nor a few sudden ones
/// change. 1 counts as ten more of them. Pure.
double turnNoiseScale(const std::vector<std::vector<TurnNode>> &segments);

} // namespace odo
