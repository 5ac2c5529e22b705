// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"

namespace odo::test {

/// How much of a robot a camera does not see at a time of the scene, 0 to 1, of points spread over its body:
/// outside the picture, behind a board, or behind another robot.
double hiddenShare(const SimulatedScene &scene, int camera, std::size_t robot, double timeS);

/// Whether a reflection or a board is near a robot (0.35 m between its centre and the disturbance's edge) at
/// a time of the scene, or a frame before or after it; a board that hides a part of it counts however far it
/// stands.
bool isDisturbed(const SimulatedScene &scene, std::size_t robot, double timeS);

} // namespace odo::test
