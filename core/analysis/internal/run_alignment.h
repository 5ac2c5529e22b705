// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/internal/path_following.h"
#include "core/analysis/profile.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// What counts as the same moment of two runs.
enum class AlignBy {
    StartGate,   ///< the first passing of the task's start
    MotionOnset, ///< the robot begins to move
    Distance,    ///< the first arrival at one place of the way
    ByHand,      ///< moments that a person told
};

/// "start_gate", "motion_onset", "distance", "hand".
std::string_view alignByWord(AlignBy by);

/// A run's moment that is taken as time 0, with its σ in two parts as of an Arrival.
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

/// A moment that a person chose by the pictures: known to a frame, evenly spread over its interval (JCGM
/// 100:2008, 4.3.7).
AlignedMoment handMoment(double timeS, const std::vector<Sample> &samples);

/// When the run proper begins: the onset of its first motion, seen or not; nullopt: it never moves.
std::optional<double> firstMotionS(const std::vector<Sample> &samples,
                                   const std::vector<ProfilePoint> &points);

/// The way that a run took, as a reference path for others: its smoothed places from the onset of motion to
/// the last stop, at least 5 mm apart, straight across gaps. A run that comes back to where it began, in the
/// same direction, has driven a closed path, of which the first lap is taken. Without points when the robot
/// never moves by as much.
ReferencePath pathOfRun(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points);

/// The path driven the other way; a closed one begins at the same point.
ReferencePath reversed(ReferencePath path);

/// How far the points of a path lie apart at most: the diagonal of the box round them.
double extentOf(const ReferencePath &path);

} // namespace odo
