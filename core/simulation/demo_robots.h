// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"

#include <string>

namespace odo {

/// A plain box of one colour, 260 × 190 × 60 mm.
SimulatedRobot demoBox(std::string name, RgbColour colour, std::shared_ptr<const Motion> motion);

/// What most classrooms have, in greys and black: a chassis on four wheels, 220 × 192 mm, with a deck, a circuit board and a mast.
SimulatedRobot demoRover(std::string name, std::shared_ptr<const Motion> motion);

} // namespace odo
