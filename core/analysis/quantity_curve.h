// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"

#include <optional>
#include <vector>

namespace odo {

/// What a chart shows of a profile, and what is counted and fitted over a range of it.
enum class Quantity { Speed, Acceleration, Heading, TurnRate, PositionX, PositionY };

/// A value of a quantity with its σ.
struct CurveValue
{
    double value = 0, sigma = 0;
};
/// So many σ to either side hold 95 % of a normal distribution (JCGM 100:2008, table G.1): the reach of
/// bands, and the bound of what chance alone gives.
constexpr double coverage95 = 1.959964;

/// The smoothed values of a quantity at all points of a profile, as many as there are points; nullopt where
/// it has none. World frame, SI. Speed: |v|. Acceleration: along the path, a·v/|v|, so that braking is
/// negative; |a| while it stands. Heading: of the motion, without steps of a whole turn, while it stands the
/// last one with a σ of 0. Turn rate: none while it stands. Position: σ with the calibration's part. Pure.
std::vector<std::optional<CurveValue>> quantityValues(const Profile &profile, Quantity quantity);

/// The same out of the positions before smoothing, by the differences that Tracker uses: speed and heading of
/// (x₊₁ − x₋₁)/2Δt, acceleration of (2x₊₂ − x₊₁ − 2x − x₋₁ + 2x₋₂)/7Δt² along the smoothed path, a position
/// as it was measured. nullopt where one of the samples that it takes is rejected or missing, for a heading
/// while the robot stands, and everywhere for the turn rate, which is nothing but noise. No σ (0) but for
/// positions, whose σ is the measurement's own, without the calibration's part.
std::vector<std::optional<CurveValue>> measuredValues(const Profile &profile, Quantity quantity);

/// As the speed of measuredValues for one sample, whether it is rejected or not.
std::optional<double> measuredSpeed(const Profile &profile, std::size_t sample);

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
