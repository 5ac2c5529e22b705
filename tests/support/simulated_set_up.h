// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/simulation/scene.h"

namespace odo {
class Project;
}

namespace odo::test {

/// Registers a simulated camera where it stands, by the markers of a stored layout as it sees them.
Result<void> registerSimulatedCamera(Project &project, const SimulatedCamera &camera,
                                     const MarkerLayout &places, RecordId layout);
/// The robot with its name, its height and, where it is given, the colour of its top.
Result<void> addSimulatedRobot(Project &project, const SimulatedRobot &seen, bool isColourGiven = true);

} // namespace odo::test
