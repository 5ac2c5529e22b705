// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/simulation/scene.h"

#include <filesystem>

namespace odo {

class Project;

/// The exact states of a scene's robot at the frames of its first camera, in that camera's time.
TruthSeries truthOf(const SimulatedScene &scene, std::size_t robot);

/// Stores the truth of a simulated trial in the project, and beside it as "<trial>_<robot>.csv" with the columns
/// t_s,x_mm,y_mm,vx_mm_s,vy_mm_s,ax_mm_s2,ay_mm_s2.
Result<void> keepTruth(Project &project, const TrialRecord &trial, const SimulatedScene &scene,
                       const std::filesystem::path &folder);

} // namespace odo
