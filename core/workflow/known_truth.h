// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/simulation/scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>

namespace odo {

class Project;

/// The exact states of a scene's robot at the frames of its first camera, in that camera's time.
TruthSeries truthOf(const SimulatedScene &scene, std::size_t robot);

/// Stores the truth of a simulated trial in the project, and beside it as "<trial>_<robot>.csv" with the
/// columns t_s,x_mm,y_mm,vx_mm_s,vy_mm_s,ax_mm_s2,ay_mm_s2.
Result<void> keepTruth(Project &project, const TrialRecord &trial, const SimulatedScene &scene,
                       const std::filesystem::path &folder);

/// How far a profile lies from a known truth. Only where the profile is valid.
struct TruthAccuracy
{
    std::int64_t compared = 0;
    double positionRmsM = 0, velocityRmsMps = 0, accelerationRmsMps2 = 0; ///< of the vector differences
    /// parts of samples whose 95 % interval holds the truth
    double insideX95 = 0, insideY95 = 0, insideSpeed95 = 0;
};

/// Which values of a truth belong to a time (within 0.1 ms); nullopt: none.
std::optional<std::size_t> truthAt(const TruthSeries &truth, Nanoseconds time);

/// Samples and truth are matched by time (within 0.1 ms); both count from the first view's first frame.
TruthAccuracy compareWithTruth(const Profile &profile, const TruthSeries &truth);

} // namespace odo
