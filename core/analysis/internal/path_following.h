// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/motion_stretches.h"

#include <optional>
#include <vector>

namespace odo {

/// Where a robot is with respect to a reference path.
struct PathPlace
{
    double stationM = 0;                            ///< way along the path to the foot of the perpendicular
    double offsetM = 0;                             ///< distance from the path, to the left of it positive
    Eigen::Vector2d left = Eigen::Vector2d::Zero(); ///< unit vector along which offsetM grows
    bool beyondEnd = false;                         ///< before the beginning or past the end of an open path
    bool jumped = false; ///< the robot came here from elsewhere on the path without driving along it
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

/// How far along a reference path a run is at one time. The way counts on over the laps of a closed path, and
/// beyond the ends of an open one along its first and last direction.
struct PathProgress
{
    double timeS = 0;
    double wayM = 0, rateMps = 0;           ///< and how fast it grows
    double ownSigmaM = 0, commonSigmaM = 0; ///< along the path: the track's own, and the calibration's
    double speedMps = 0, sigmaSpeedMps = 0;
    double offsetM = 0;  ///< from the path, to the left of it positive
    bool joined = false; ///< it drove here along the path from the place before, without a gap
};

/// The progress of a run, place by place; places further than reachM from the path are left out. path must
/// have points.
std::vector<PathProgress> progressAlong(const ReferencePath &path, const std::vector<Sample> &samples,
                                        const std::vector<ProfilePoint> &points, double reachM);

/// When a run is first at a place of the path.
struct Arrival
{
    double timeS = 0;
    double ownSigmaS =
        0; ///< half the time between the arrivals at one σ before the place and at one σ past it
    double commonSigmaS =
        0; ///< the calibration's part likewise: how much later if it puts all places back by its σ
    double speedMps = 0, sigmaSpeedMps = 0;
    double offsetM = 0;

    double sigmaS() const;
};

/// The first arrivals of one run. A run that waits has arrived before it waits, so that waiting is a step in
/// the times of what comes after; one that goes back and comes again has arrived the first time. Between two
/// places the way is the cubic through both and their rates. Immutable; any thread.
class FirstArrivals
{
public:
    FirstArrivals() = default;
    /// Of the progress from a time on.
    FirstArrivals(const std::vector<PathProgress> &progress, double fromS);

    /// nullopt: never there, or there in a gap.
    std::optional<Arrival> at(double wayM) const;
    bool isEmpty() const { return m_steps.empty(); }
    double firstM() const { return m_steps.front().fromM; } ///< not of an empty one
    double lastM() const { return m_steps.back().toM; }

private:
    /// A step between two places in which the run gets further than ever before: from fromM to toM.
    struct Step
    {
        double fromM = 0, toM = 0;
        PathProgress before, after;
    };
    const Step *stepAt(double wayM) const;
    static double partAt(const Step &step, double wayM);
    std::optional<double> timeAt(double wayM) const;
    double sigmaOf(double timeS, double wayM, double sigmaM, double rateMps) const;

    std::vector<Step> m_steps; ///< in order of the way
};

} // namespace odo
