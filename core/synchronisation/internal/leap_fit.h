// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace odo {

/// A robot in one frame: in pixels, at a time in s.
struct TimedPixel
{
    double timeS = 0;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
};

/// What lies on both sides of an interval between two frames, in order: fewest of each or more.
struct AroundInterval
{
    std::vector<TimedPixel> before, behind;
    double noisePx = 0; ///< of a coordinate, at least
};
inline constexpr std::size_t fewestBeside = 4;

/// Whether a robot gets over an interval as it moves before and after.
struct LeapTest
{
    /// in σ: how far the parabolas before and after stay apart at every moment of the interval. A blow
    /// changes the velocity at some moment, at which they meet.
    double apart = 0;
    Eigen::Vector2d excessPx = Eigen::Vector2d::Zero(); ///< beyond what any of both velocities explains
    double irregularPx = 0; ///< the largest change from one step to the next on either side
    double stepPx = 0;      ///< of the mean velocity, in a usual interval
    double fastestPx = 0;   ///< of the larger velocity, likewise
    double noisePx = 0;     ///< with what the parabolas leave
};
LeapTest leapTest(const AroundInterval &around, double usualS);

/// By how much more time than stamped the interval took, if the robot moved smoothly.
struct DelayFit
{
    double delayS = 0, sigmaS = 0;
    double misfit = 0; ///< variance of what remains, over that of the noise: about 1
    double gain = 0;   ///< by how much the delay lowers the squared sum, in variances of the noise
};

/// Least squares of one cubic through both sides, the second one delayed by leastS to mostS: Gauss–Newton
/// from the best of a grid. noisePx: as of LeapTest. nullopt: the best is at an end.
std::optional<DelayFit> fitDelay(const AroundInterval &around, double noisePx, double leastS, double mostS,
                                 double stepS);

} // namespace odo
