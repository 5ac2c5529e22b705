// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/models/camera_lists.h"
#include "ui/models/trial_scene.h"
#include "ui/testbed/check/floor_sketch.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/views/widgets/fact_list.h"

#include <vector>

namespace odo {

class Project;

/// The project's cameras with what a registration needs; those without a lens as well. Project's thread.
Result<std::vector<FloorCamera>> floorCameras(Project &project);

/// Those that are registered, as the checks take them. Project's thread.
Result<std::vector<CheckCamera>> checkCameras(Project &project);

/// A scene with no robots: the newest recording of a camera with the registration in force. Null when the
/// camera has recorded nothing yet. Project's thread.
Result<TrialScenePtr> newestImage(Project &project, const CameraRow &camera);

/// All that is known of a camera: intrinsics, registration, the error of each marker, and the verdicts in
/// words.
QList<Fact> cameraFacts(const CameraRow &camera);

/// Those of the cameras that are registered on the layout, as seen from above. Project's thread.
Result<std::vector<SketchedCamera>> sketchedCameras(Project &project, const std::vector<CameraRow> &cameras,
                                                    RecordId layout);

} // namespace odo
