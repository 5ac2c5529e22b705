// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/clock_repair.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace odo {

/// A floor position at a time of the view's own clock, zero at its first frame.
struct TimedPosition
{
    double timeS = 0;
    Eigen::Vector2d pointInWorld;
};

/// Of its intervals; 0 without any.
double medianStepS(const std::vector<TimedPosition> &track);

/// σ of a coordinate of a position, from how each lies beside its neighbours.
double whiteNoiseM(const std::vector<TimedPosition> &track);

/// The means of neighbouring positions of a fast camera: they carry the same information, and the search time
/// falls with the square of their number. A group ends at a gap.
std::vector<TimedPosition> thinned(const std::vector<TimedPosition> &track);

struct PositionAndVelocity
{
    Eigen::Vector2d point, velocity;
    double velocityVariance =
        0; ///< of both components together, from how the positions scatter about the parabola
};

/// The track at a time, by a parabola fitted to what lies within ±0.2 s, nearer positions weighing more
/// (local quadratic regression, Cleveland 1979). Plain interpolation between two noisy positions will not do:
/// its noise is least half-way between them, which draws the offset towards half frames. nullopt outside the
/// track and where it has a gap.
std::optional<PositionAndVelocity> trackAt(const std::vector<TimedPosition> &track, double timeS);

/// How the second view's positions lie on the first view's: shifted, and larger about a point.
struct Lie
{
    Eigen::Vector2d shift = Eigen::Vector2d::Zero(), middle = Eigen::Vector2d::Zero();
    double scale = 0;

    Eigen::Vector2d onFirst(const Eigen::Vector2d &second) const
    {
        return second + shift + scale * (second - middle);
    }
};

/// A track with its times as they are after a repair of its clock.
std::vector<TimedPosition> restamped(std::vector<TimedPosition> track, const ClockRepair &repair);

} // namespace odo
