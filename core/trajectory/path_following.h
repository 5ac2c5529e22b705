// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/measured_places.h"

#include <optional>
#include <vector>

namespace odo {

/// Where a robot is with respect to a reference path.
struct PathPlace
{
    double stationM = 0; ///< way along the path to the foot of the perpendicular
    double offsetM = 0;  ///< distance from the path, to the left of it positive
    Eigen::Vector2d left = Eigen::Vector2d::Zero(); ///< unit vector along which offsetM grows
    bool beyondEnd = false; ///< before the beginning or past the end of an open path
    bool jumped = false;    ///< the robot came here from elsewhere on the path without driving along it
};

double lengthOf(const ReferencePath &path);

/// The place on the path of each position of a run. Of several feet (a path may cross itself) the one is
/// taken that makes the whole run likeliest: the sum over the run of offset² · way driven is least, where
/// going on at a station that the way driven since does not explain costs as much as half a metre at an
/// offset of 100 mm (dynamic programming: Viterbi 1967). One place for each position; path must have points.
std::vector<PathPlace> followPath(const ReferencePath &path, const std::vector<MeasuredPlace> &places);

/// The part of the path that was driven along, 0 to 1, counted in thousandths.
constexpr double completedResolution = 0.001;
double completedShare(const ReferencePath &path, const std::vector<PathPlace> &followed);

} // namespace odo
