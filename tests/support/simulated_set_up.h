// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/simulation/scene.h"

namespace odo {
class Project;
}

namespace odo::test {

/// Registers a simulated camera where it stands, by the markers of a stored layout as it sees them.
Result<void> registerSimulatedCamera(Project &project, const SimulatedCamera &camera, const MarkerLayout &places, RecordId layout);
/// The robot with its name, the colour of its top, and its height.
Result<void> addSimulatedRobot(Project &project, const SimulatedRobot &seen);

} // namespace odo::test
