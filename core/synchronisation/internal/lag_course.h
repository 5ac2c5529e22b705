// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/track_sampling.h"

#include <vector>

namespace odo {

/// A time over which the second view's clock lags the first view's by the same.
struct LagPiece
{
    double fromS = 0, toS = 0; ///< of the first view's clock
    double lagS = 0;           ///< what the second view stamps u was taken at lag + u / (1 + rate)
};

/// How the lag between two views runs over the time, at a given rate of the second clock.
struct LagCourse
{
    double rate = 0;
    std::vector<LagPiece> pieces; ///< in order; none where the tracks have nothing in common
    double noiseM = 0;            ///< in a coordinate, of what remains
    double cost = 0;              ///< negative log-likelihood, less what a course without any jump would cost
};

/// The lags to look at.
struct LagRange
{
    double fromS = 0, toS = 0;
};

/// Two tracks that are compared at any lag and rate, each at the other's pace.
class LagSearch
{
public:
    LagSearch(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
              const LagRange &range);

    /// The likeliest course of the lag that jumps as rarely as it can: dynamic programming over time and lag,
    /// first of the velocities, which no constant shift between the views changes, then of the positions
    /// about the shift and the scale so found. noiseM: of a coordinate; 0: as it is found.
    LagCourse courseAt(double rate, double noiseM = 0) const;

private:
    const std::vector<TimedPosition> &m_first, &m_second;
    LagRange m_range;
};

} // namespace odo
