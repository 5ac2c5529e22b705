// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

namespace odo {

class Project;

/// "Year 9 robotics — Trial 1, Team Falcon — Odograph". project, trial: null where none is open or on screen.
QString windowTitleOf(const Project *project, const TrialScenePtr &trial);

} // namespace odo
