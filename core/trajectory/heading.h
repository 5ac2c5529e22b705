// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <optional>
#include <vector>

namespace odo {

/// Direction and turning of the motion (not of the robot's body: it may run backwards or sideways). World
/// frame, anticlockwise from +X; radians and radians a second.
struct Course
{
    double headingRad = 0, sigmaHeadingRad = 0;
    double turnRateRadps = 0, sigmaTurnRateRadps = 0;
};

/// The course of one point: heading = atan2(vy, vx) in (−π, π], turn rate = (vx·ay − vy·ax)/|v|². nullopt
/// where the speed is not clear of its noise (three σ). σ by first order, with the profile's σ of speed and
/// acceleration taken as those of each axis and as independent of one another (in the middle of a smoothed
/// track they are): σ²(heading) = σᵥ²/|v|², σ²(turn rate) = σₐ²/|v|² + |a|²σᵥ²/|v|⁴.
std::optional<Course> courseOf(const ProfilePoint &point);

/// A heading through time, without steps of a whole turn.
struct Heading
{
    double radians = 0;
    std::optional<double> sigmaRad; ///< empty: kept from the last time that it was known
};

/// The headings of a profile's points, unwrapped: of all headings that are the same direction the one next to
/// the last. While the robot stands the last one is kept, before it first moves that of its start. nullopt
/// where the point is not valid, and everywhere for a robot that never moves. The result is as long as
/// points.
std::vector<std::optional<Heading>> headingsOf(const std::vector<ProfilePoint> &points);

} // namespace odo
