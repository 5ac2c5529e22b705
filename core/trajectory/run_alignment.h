// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/path_progress.h"
#include "core/trajectory/profile.h"

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

} // namespace odo
