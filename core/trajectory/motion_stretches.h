// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <cstddef>
#include <span>
#include <vector>

namespace odo {

/// One valid point of a profile with its time. point refers to the profile it was made from.
struct RunInstant
{
    double timeS = 0;
    const ProfilePoint *point = nullptr;
    double thresholdMps = 0; ///< above it the robot counts as moving
    double commonSigmaM = 0; ///< of the position, from the calibration alone
};

/// A stretch of motion: first and last instant above the threshold, and the interpolated moments of crossing
/// it.
struct MotionStretch
{
    std::size_t first = 0, last = 0;
    double startS = 0, stopS = 0;
};

/// The valid points in order of time.
std::vector<RunInstant> validInstants(const std::vector<Sample> &samples,
                                      const std::vector<ProfilePoint> &points);
/// Those of a part of a run, behind the ones before. commonSigmaM: of the last used sample so far, 0 at first.
void appendInstants(std::span<const Sample> samples, std::span<const ProfilePoint> points, double &commonSigmaM,
                    std::vector<RunInstant> &instants);

/// No robot moves more slowly.
inline constexpr double leastMovingMps = 0.02;

/// Where the robot moves: faster than leastMovingMps and than three σ of the speed, for at least three
/// instants.
std::vector<MotionStretch> findMotions(const std::vector<RunInstant> &instants);

/// σ of the moment of crossing the threshold next to an instant: the speed's σ over its steepness, at most
/// what the neighbours leave open.
double sigmaOfMoment(const std::vector<RunInstant> &instants, std::size_t at);

/// For how long the errors of a smoothed track go together, seconds: an error of the size σ whose rate is
/// that of the speed's changes within σ/σᵥ; times √2π it is the integral of a correlation of Gaussian shape.
double correlationTimeS(const RunInstant &instant);

/// σ of the position, mean of both axes, the calibration's part included.
double sigmaOfPosition(const ProfilePoint &point);

} // namespace odo
