// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace odo {

/// One moment that two views recorded.
struct EventPair
{
    double firstS = 0, secondS = 0; ///< each by its own clock
    double variance = 0;            ///< of their difference, s²

    double offsetS() const { return firstS - secondS; }
};

/// firstS = offset + secondS · (1 − rate), with the standard deviations of both.
struct ClockLine
{
    double offsetS = 0, rate = 0, offsetSigmaS = 0;
    double rateSigma = 0; ///< 0: the pairs are too few or too near each other to say anything of the rate
};

/// Fits the relation of two clocks to pairs, by least squares weighted by their variances, which are taken as
/// larger where the pairs scatter more. With three pairs over 20 s the rate is fitted too, and taken beyond
/// 3σ. Pure; any thread.
ClockLine clockLineThrough(const std::vector<EventPair> &pairs);

} // namespace odo
