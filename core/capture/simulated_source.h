// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/capture/pace.h"
#include "core/simulation/renderer.h"

namespace odo {

/// A camera before which somebody holds a board: in each pose for a second, then moving on to the next within half a
/// second; from the start again after the last.
std::unique_ptr<CameraSource> simulatedBoardSource(CameraDescription description, CameraModel camera, const SimulatedBoard &board,
                                                   std::vector<RigidTransform> cameraFromBoard, Pace::Kind pace);

/// A camera of a scene, which begins anew when it is over. Cameras that are told one start see it at one time. The robots that it is to show
/// instead of the scene's drive as circlingRobots.
std::unique_ptr<CameraSource> simulatedSceneSource(CameraDescription description, SimulatedScene scene, int camera,
                                                   Pace::Kind pace, Pace::Start start = std::nullopt);

} // namespace odo
