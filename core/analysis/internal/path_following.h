// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/motion_stretches.h"
#include "core/analysis/profile.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// Where a robot is with respect to a reference path.
struct PathPosition
{
    double stationM = 0;                            ///< way along the path to the foot of the perpendicular
    double offsetM = 0;                             ///< distance from the path, to the left of it positive
    Eigen::Vector2d left = Eigen::Vector2d::Zero(); ///< unit vector along which offsetM grows
    bool beyondEnd = false;                         ///< before the beginning or past the end of an open path
    bool jumped = false; ///< the robot came here from elsewhere on the path without driving along it
};

double lengthOf(const ReferencePath &path);

/// The position along the path of each sample of a run. Of several feet (a path may cross itself) the one is
/// taken that makes the whole run likeliest: the sum over the run of offset² · distance travelled is least,
/// where continuing at a station that the distance travelled since does not explain costs as much as half a
/// metre at an offset of 100 mm (dynamic programming: Viterbi 1967). One result for each sample; path must
/// have points.
std::vector<PathPosition> followPath(const ReferencePath &path,
                                     const std::vector<MeasuredPosition> &positions);

/// The part of the path that was driven along, 0 to 1, counted in thousandths.
constexpr double completedResolution = 0.001;
double completedShare(const ReferencePath &path, const std::vector<PathPosition> &followed);

/// How far along a reference path a run is at one time. The way counts on over the laps of a closed path, and
/// beyond the ends of an open one along its first and last direction.
struct PathProgress
{
    double timeS = 0;
    double pathM = 0, rateMps = 0;          ///< and how fast it grows
    double ownSigmaM = 0, commonSigmaM = 0; ///< along the path: the track's own, and the calibration's
    double speedMps = 0, sigmaSpeedMps = 0;
    double offsetM = 0;  ///< from the path, to the left of it positive
    bool joined = false; ///< it drove here along the path from the position before, without a gap
};

/// The progress of a run, position by position; positions further than reachM from the path are left out.
/// path must have points.
std::vector<PathProgress> progressAlong(const ReferencePath &path, const std::vector<Sample> &samples,
                                        const std::vector<ProfilePoint> &points, double reachM);

/// When a run is first at a position of the path.
struct Arrival
{
    double timeS = 0;
    double ownSigmaS =
        0; ///< half the time between the arrivals at one σ before the position and at one σ past it
    double commonSigmaS =
        0; ///< the calibration's part likewise: how much later if it shifts all positions back by its σ
    double speedMps = 0, sigmaSpeedMps = 0;
    double offsetM = 0;

    double sigmaS() const;
};

/// The first arrivals of one run. A run that waits has arrived before it waits, so waiting is a step in all
/// later times; a run that goes back and returns has arrived the first time. Between two positions the
/// progress is the cubic through both and their rates. Immutable; any thread.
class FirstArrivals
{
public:
    FirstArrivals() = default;
    /// Of the progress from a time on.
    FirstArrivals(const std::vector<PathProgress> &progress, double fromS);

    /// nullopt: never there, or there in a gap.
    std::optional<Arrival> at(double pathM) const;
    bool isEmpty() const { return m_steps.empty(); }
    double firstM() const { return m_steps.front().fromM; } ///< not of an empty one
    double lastM() const { return m_steps.back().toM; }

private:
    /// A step between two positions in which the run gets further than ever before: from fromM to toM.
    struct Step
    {
        double fromM = 0, toM = 0;
        PathProgress before, after;
    };
    const Step *stepAt(double pathM) const;
    static double partAt(const Step &step, double pathM);
    std::optional<double> timeAt(double pathM) const;
    double sigmaOf(double timeS, double pathM, double sigmaM, double rateMps) const;

    std::vector<Step> m_steps; ///< in order of the way
};

/// What counts as the same moment of two runs.
enum class AlignBy {
    StartGate,   ///< the first passing of the task's start
    MotionOnset, ///< the robot begins to move
    Distance,    ///< the first arrival at one position on the path
    ByHand,      ///< moments that a person entered
};

/// "start_gate", "motion_onset", "distance", "hand".
std::string_view alignByWord(AlignBy by);

/// A run's moment that counts as time 0, with its σ in two parts as of an Arrival.
struct AlignedMoment
{
    double timeS = 0;
    double ownSigmaS = 0, commonSigmaS = 0;
};

/// The first passing of the task's start; nullopt: it has none, or it was not passed.
std::optional<AlignedMoment> startGateMoment(const Task &task, const std::vector<Sample> &samples,
                                             const std::vector<ProfilePoint> &points);

/// The onset of the first motion (findMotions); nullopt: none, or the robot was driving already when it was
/// first seen.
std::optional<AlignedMoment> onsetMoment(const std::vector<Sample> &samples,
                                         const std::vector<ProfilePoint> &points);

/// A moment that a person chose by looking at the frames: known to one frame, evenly spread over its interval
/// (JCGM 100:2008, 4.3.7).
AlignedMoment handMoment(double timeS, const std::vector<Sample> &samples);

/// When the run proper begins: the onset of its first motion, seen or not; nullopt: it never moves.
std::optional<double> firstMotionS(const std::vector<Sample> &samples,
                                   const std::vector<ProfilePoint> &points);

/// The path of a run, as a reference path for others: its smoothed positions from the onset of motion to the
/// last stop, at least 5 mm apart, straight across gaps. A run that comes back to where it began, in the same
/// direction, has driven a closed path, of which the first lap is taken. Without points when the robot never
/// moves by as much.
ReferencePath pathOfRun(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points);

/// The path driven the other way; a closed one begins at the same point.
ReferencePath reversed(ReferencePath path);

/// How far the points of a path lie apart at most: the diagonal of the box round them.
double extentOf(const ReferencePath &path);

} // namespace odo
