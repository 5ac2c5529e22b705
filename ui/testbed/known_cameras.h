// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/testbed/check/check_camera.h"
#include "ui/testbed/floor/floor_camera.h"

#include <vector>

namespace odo {

class Project;

/// The project's cameras with what a registration needs; those without a lens as well. Project's thread.
Result<std::vector<FloorCamera>> floorCameras(Project &project);

/// Those that are registered, as the checks take them. Project's thread.
Result<std::vector<CheckCamera>> checkCameras(Project &project);

} // namespace odo
