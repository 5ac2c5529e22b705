// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"

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
    bool joined = false;     ///< no gap since the instant before it
    bool measured = true;    ///< false: bridged, between two that are measured
    /// Of a measured one: for how long nothing was measured before it, where that is longer than usual.
    double bridgedS = 0;
};

/// A stretch of motion: its first and last instant, and the moments outside them when the robot started and
/// stopped, with its speed then. At a gap and at the ends of the run these are the instants themselves.
struct MotionStretch
{
    std::size_t first = 0, last = 0;
    double startS = 0, stopS = 0;
    double startMps = 0, stopMps = 0;
};

/// So many times its usual interval is bridged of a track that is slower by itself than the longest gap.
inline constexpr int bridgedIntervals = 4;

/// Detects the gaps of a run while it reads the points in order of time. Between two valid points is a gap
/// where others that are not valid are between them, or where more time passed than is bridged: 1.5 s, or
/// bridgedIntervals times the step before it.
class GapWatch
{
public:
    void skip() { m_skipped = true; } ///< a point that is not valid
    /// A valid point. Whether it follows the one before it without a gap; false for the first.
    bool joins(double timeS);

private:
    double m_lastS = 0, m_stepS = 0; ///< the last valid point; the last step without a gap, 0: none yet
    bool m_skipped = true;           ///< since the last valid point, or there was none
};

/// What is carried from one part of a run to the next.
struct RunState
{
    double commonSigmaM = 0; ///< of the last used sample
    GapWatch gaps;
    double measuredS = 0, stepS = 0; ///< the last measured point; the usual step between two
};

/// The valid points in order of time.
std::vector<RunInstant> validInstants(const std::vector<Sample> &samples,
                                      const std::vector<ProfilePoint> &points);
/// Those of a part of a run, behind the ones before.
void appendInstants(std::span<const Sample> samples, std::span<const ProfilePoint> points, RunState &state,
                    std::vector<RunInstant> &instants);

/// Where nothing is known of the robot between its first and its last instant, in order of time.
std::vector<TimeSpan> gapsBetween(const std::vector<RunInstant> &instants);
/// Sets gaps and measuredS of a profile from its instants.
void measureGaps(const std::vector<RunInstant> &instants, Profile &profile);

/// Where the robot moves: faster than three σ of its speed for at least three instants, and meanwhile further
/// than the σ of the positions explains. The run's own σ decides: what a robot that creeps does in a second
/// may be noise, what it does in a minute is not. A stretch ends at a gap: what happens there is not known.
/// Through a bridged stretch a robot goes on that moves before and after it.
std::vector<MotionStretch> findMotions(const std::vector<RunInstant> &instants);

/// Two measured instants between which nothing was measured for longer than usual, and which are joined: the
/// positions between them are bridged.
struct BridgedStretch
{
    std::size_t first = 0, last = 0;
};
/// In order of time.
std::vector<BridgedStretch> bridgedStretches(const std::vector<RunInstant> &instants);
/// Whether the robot is at rest at an instant, by its speed.
bool isAtRest(const RunInstant &instant);

/// Of two positions, and σ of what noise makes of it.
double distanceBetween(const RunInstant &a, const RunInstant &b);
double sigmaOfDistance(const RunInstant &a, const RunInstant &b);
/// Whether the robot is further from where it was than noise goes: 4.5 σ.
bool isApart(const RunInstant &from, const RunInstant &to);

/// σ of the moment of crossing the threshold next to an instant: the speed's σ over its steepness, at most
/// what the neighbours leave open.
double sigmaOfMoment(const std::vector<RunInstant> &instants, std::size_t at);

/// For how long the errors of a smoothed track go together, seconds: an error of the size σ whose rate is
/// that of the speed's changes within σ/σᵥ; times √2π it is the integral of a correlation of Gaussian shape.
double correlationTimeS(const RunInstant &instant);

/// σ of the position, mean of both axes, the calibration's part included.
double sigmaOfPosition(const ProfilePoint &point);
/// The same without the calibration's part.
double ownSigmaOfPosition(const RunInstant &instant);

/// The distance travelled from the start of a stretch of motion to each of its instants, metres: the integral
/// of the speed by the trapezoidal rule, and over a bridged time without points the length of the cubic;
/// before it the distance from where the robot rested, or the ramp from the start to the first instant. As
/// long as the stretch.
std::vector<double> distancesOf(const MotionStretch &motion, const std::vector<RunInstant> &instants);

/// The length of a stretch of motion: distancesOf, and to where the robot rests then or the ramp at its end,
/// metres.
double lengthOf(const MotionStretch &motion, const std::vector<RunInstant> &instants);

/// The distance travelled up to each sample, metres; it never decreases, and ends with the metric
/// path_length. It is constant while the robot stands still and where its points are not valid. As long as
/// samples.
std::vector<double> distanceTravelled(const std::vector<Sample> &samples,
                                      const std::vector<ProfilePoint> &points);

/// So many σ of the track's own noise beyond a line a robot surely is beyond it. Where it brakes or starts
/// hard the smoothed track swings by up to 4.6 σ (200 runs), so it is more than chance alone asks for.
inline constexpr double sureSigmas = 6;

/// One valid point of a profile with the covariance of its position in its two parts: the track's own, which
/// changes along it, and the calibration's, common to all of it. m², world frame.
struct MeasuredPosition
{
    double timeS = 0;
    const ProfilePoint *point = nullptr; ///< refers to the profile it was made from
    Eigen::Matrix2d own = Eigen::Matrix2d::Zero(), common = Eigen::Matrix2d::Zero();
    bool joined = false; ///< no gap since the point before it
};

/// The valid points in order of time, as validInstants gives them. A profile keeps σ of x and y alone: their
/// correlation comes from the measurement at the same time.
std::vector<MeasuredPosition> measuredPositions(const std::vector<Sample> &samples,
                                                const std::vector<ProfilePoint> &points);

/// σ of a position along a unit vector.
double sigmaAlong(const Eigen::Matrix2d &covariance, const Eigen::Vector2d &direction);

/// The cubic through two values with their rates, over a step of time (Hermite). part runs from 0 to 1 over
/// the step.
struct CubicStep
{
    double from = 0, to = 0, rateFrom = 0, rateTo = 0, stepS = 0;

    double value(double part) const
    {
        const double rest = 1 - part;
        return rest * rest * ((1 + 2 * part) * from + part * stepS * rateFrom) +
               part * part * ((1 + 2 * rest) * to - rest * stepS * rateTo);
    }
    double rate(double part) const
    {
        return 6 * part * (1 - part) * (to - from) / stepS + (1 - part) * (1 - 3 * part) * rateFrom +
               part * (3 * part - 2) * rateTo;
    }
    /// At its beginning and its end.
    double accelerationFrom() const { return curvature(2 * rateFrom + rateTo); }
    double accelerationTo() const { return -curvature(rateFrom + 2 * rateTo); }
    /// The part at which it is zero; from and to have different signs.
    double root() const
    {
        double low = 0, high = 1;
        for (int i = 0; i < 50; ++i) {
            const double middle = (low + high) / 2;
            ((value(middle) > 0) == (to > 0) ? high : low) = middle;
        }
        return (low + high) / 2;
    }

private:
    double curvature(double rates) const { return 2 * (3 * (to - from) / stepS - rates) / stepS; }
};

/// The cubic from one instant to another, each axis by itself.
struct CubicPath
{
    CubicPath(const RunInstant &from, const RunInstant &to);
    Eigen::Vector2d velocity(double part) const { return {x.rate(part), y.rate(part)}; }
    double lengthM() const;
    static constexpr int parts = 24; ///< fine enough for lengths and directions

    CubicStep x, y;
};

} // namespace odo
