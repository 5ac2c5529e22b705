// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <vector>

namespace odo {

/// One valid point of a profile with the covariance of its position in its two parts: the track's own, which
/// changes along it, and the calibration's, common to all of it. m², world frame.
struct MeasuredPlace
{
    double timeS = 0;
    const ProfilePoint *point = nullptr; ///< refers to the profile it was made from
    Eigen::Matrix2d own = Eigen::Matrix2d::Zero(), common = Eigen::Matrix2d::Zero();
    bool joined = false; ///< the point before it is valid too: no gap between
};

/// The valid points in order of time, as validInstants gives them. A profile keeps σ of x and y alone: how
/// their errors go together is taken from the measurement at the same time.
std::vector<MeasuredPlace> measuredPlaces(const std::vector<Sample> &samples,
                                          const std::vector<ProfilePoint> &points);

/// σ of a position along a unit vector.
double sigmaAlong(const Eigen::Matrix2d &covariance, const Eigen::Vector2d &direction);

} // namespace odo
