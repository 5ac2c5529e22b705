// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/record/camera_choice.h"
#include "ui/record/running_cameras.h"

namespace odo {

class Project;

/// The cameras that are used, each with its registration in force. Project's thread.
Result<std::vector<WantedCamera>> wantedCameras(Project &project, const std::vector<ChosenCamera> &chosen);

/// What is known of the floor before anything is recorded: the views, the layout of the first one that is
/// registered, and the task; no robots. Project's thread.
Result<TrialScenePtr> liveScene(Project &project, const std::vector<WantedCamera> &cameras,
                                const std::optional<Task> &task);

} // namespace odo
