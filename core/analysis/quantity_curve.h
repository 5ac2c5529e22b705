// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/base/coverage.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace odo {

/// What a chart shows of a profile, and what is counted and fitted over a range of it.
enum class Quantity {
    Speed,
    Acceleration,
    Heading,
    TurnRate,
    PositionX,
    PositionY,
    VelocityX,
    VelocityY,
    LateralAcceleration,
    Jerk,
    Distance,     ///< travelled
    Displacement, ///< straight from where the robot was first seen
    Separation,   ///< from the nearest of the other robots
};
/// All of them, in the order in which they are offered.
std::span<const Quantity> allQuantities();

/// A jerk is the mean over this time, or over as little more as the samples are apart: that of one instant
/// has no finite σ, for the smoother assumes a white jerk.
inline constexpr double jerkSpanS = 0.2;

/// Of the other robots of a trial.
using OtherProfiles = std::span<const Profile *const>;

/// A value of a quantity with its σ.
struct CurveValue
{
    double value = 0, sigma = 0;
};

/// The smoothed values of a quantity at all points of a profile, as many as there are points; nullopt where
/// it has none. World frame, SI. Speed: |v|. Acceleration: along the path, a·v/|v|, so that braking is
/// negative; |a| while it stands still. Heading: headingsOf; one that is kept has a σ of 0. Turn rate:
/// turnRateOf. Position: σ with the calibration's part. Velocity: along X and Y, each with the σ of the
/// speed. Lateral acceleration: (vx·ay − vy·ax)/|v|, positive to the left; none where the robot stands; σ² =
/// σₐ² + (a·v/|v|)²σᵥ²/|v|². Jerk: (a(t₂) − a(t₁))/(t₂ − t₁) along the path, t₁ and t₂ jerkSpanS/2 before and
/// after without a gap between, its length while the robot stands; σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)² with
/// errorCorrelation of the acceleration. Distance: distanceTravelled; σ of the ends of its motions, of errors
/// across a path that turns, and of the calibration's scale, without what the robot may have done while it
/// was not measured. Displacement: σ of both positions along the line between, and of the scale. Pure.
/// others: what was measured of other robots, for the separation: the distance of the reference points at the
/// same time, the other's interpolated between two frames without a gap; σ of both positions along the line
/// between, and of the scale.
std::vector<std::optional<CurveValue>> quantityValues(const Profile &profile, Quantity quantity,
                                                      OtherProfiles others = {});

/// The same out of the positions before smoothing, by the differences that Tracker uses: speed and heading of
/// (x₊₁ − x₋₁)/2Δt, acceleration of (2x₊₂ − x₊₁ − 2x − x₋₁ + 2x₋₂)/7Δt² along the smoothed path, a position
/// as it was measured; of a body that was measured the heading of that; a velocity as for the speed; of the
/// displacement from the first position that is used. nullopt where one of the samples that it takes is
/// rejected or missing, for a heading of the motion at standstill, and everywhere for the turn rate, the
/// lateral acceleration, the jerk, which are nothing but noise, the distance and the separation. No σ (0) but
/// for positions, whose σ is the measurement's own, without the calibration's part.
std::vector<std::optional<CurveValue>> measuredValues(const Profile &profile, Quantity quantity);

/// As the speed of measuredValues for one sample, whether it is rejected or not.
std::optional<double> measuredSpeed(const Profile &profile, std::size_t sample);

/// Direction and turning of the motion (not of the robot's body: it may run backwards or sideways). World
/// frame, anticlockwise from +X; radians and radians a second.
struct MotionCourse
{
    double headingRad = 0, sigmaHeadingRad = 0;
    double turnRateRadps = 0, sigmaTurnRateRadps = 0;
};

/// The course of one point: heading = atan2(vy, vx) in (−π, π], turn rate = (vx·ay − vy·ax)/|v|². nullopt
/// where the speed is not clear of its noise (three σ). σ by first order, with the profile's σ of speed and
/// acceleration taken as those of each axis and as independent of one another (in the middle of a smoothed
/// track they are): σ²(heading) = σᵥ²/|v|², σ²(turn rate) = σₐ²/|v|² + |a|²σᵥ²/|v|⁴.
std::optional<MotionCourse> courseOf(const ProfilePoint &point);

/// How fast a robot turns at a point, anticlockwise, rad/s: its body where that was measured, also on the
/// spot, else its course. nullopt where neither is known.
std::optional<CurveValue> turnRateOf(const ProfilePoint &point);

/// A heading through time, without steps of a whole turn.
struct Heading
{
    double radians = 0;
    std::optional<double> sigmaRad; ///< empty: kept from the last time that it was known
    bool isOfBody = false;          ///< false: the direction of motion
};
/// "body", "motion".
std::string_view headingSource(const Heading &heading);

/// The headings of a profile's points, unwrapped: of all headings that are the same direction the one next to
/// the last. Of the body where it was measured and its front is known. Elsewhere the direction of motion,
/// continued where the robot reverses: where it slows down and moves in the opposite direction (to 45°)
/// within a second, it is assumed to move backwards. A stretch of such motion begins forwards, unless more
/// than two thirds of it would be backwards; or as the body says, where that is known in it. At standstill
/// the last heading is kept; before it first moves, that of its start. nullopt where the point is not valid,
/// and everywhere where neither is ever known. The result is as long as the points.
std::vector<std::optional<Heading>> headingsOf(const Profile &profile);

/// What of a curve a chart of some width can show: the points themselves, or, where there are more of them
/// than pixels, the extremes of each pixel column. Plain values; any thread.

/// A point of a curve with its 95 % band (1.96 σ), in single precision: a trial may have a million of them.
struct BandPoint
{
    BandPoint(double position, const CurveValue &curveValue);
    double x; ///< the position on the axis below
    float value, reach;
    double low() const { return double(value) - double(reach); }
    double high() const { return double(value) + double(reach); }
    CurveValue curveValue() const;
};

/// A stretch of a profile without a gap, from one sample to another: measured, or bridged. A bridged one
/// begins and ends with measured samples, which belong to the pieces beside it, too.
struct ProfilePiece
{
    std::size_t first = 0, last = 0; ///< samples
    bool isBridged = false;
};
/// All valid points of a profile, in order; bridged pieces are those of bridgedStretches
/// (core/analysis/motion_stretches.h).
std::vector<ProfilePiece> piecesOf(const Profile &profile);

/// A stretch of a curve without gaps, sorted by x: one point a sample, from firstSample on.
struct CurveRun
{
    std::size_t firstSample = 0;
    std::vector<BandPoint> points;
    bool isLine() const { return points.size() >= 2; }
};

/// Of the pieces that are bridged, or of those that are measured. values: one a sample. positions: of each
/// sample on the axis below.
std::vector<CurveRun> curveRuns(const std::vector<std::optional<CurveValue>> &values,
                                const std::vector<double> &positions, const std::vector<ProfilePiece> &pieces,
                                bool bridged = false);

/// The points from low to high, and the next one beyond either end, so that a line runs out of the plot.
/// Points must be sorted by x.
std::span<const BandPoint> visiblePoints(std::span<const BandPoint> points, double low, double high);

/// How many points of these runs visiblePoints gives in total.
std::size_t visibleCount(std::span<const CurveRun> runs, double low, double high);

/// What a curve does within one pixel column.
struct CurveColumn
{
    int index = 0;                    ///< of the column, from 0 at the left
    bool isJoined = false;            ///< the line goes on from the column before it in the list
    double low = 0, high = 0;         ///< its extremes
    double bandLow = 0, bandHigh = 0; ///< those of its band
};

/// Whether a column reaches to the last point before it, as a line does, or shows its own points alone.
enum class ColumnReach { Line, Points };

/// The extremes of each of `count` columns between low and high, so that no peak of a single sample is lost:
/// as fast to draw for an hour as for a second. Columns without points are left out. Runs must be in order.
std::vector<CurveColumn> curveColumns(std::span<const CurveRun> runs, double low, double high, int count,
                                      ColumnReach reach = ColumnReach::Line);

} // namespace odo
