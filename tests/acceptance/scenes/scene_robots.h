// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/acceptance/scenes/scene_catalogue.h"
#include "tests/acceptance/scenes/seeded_draw.h"

#include <memory>

namespace odo::test {

constexpr RgbColour red{0xd7, 0x23, 0x28}, vermilion{0xd7, 0x42, 0x1f}, blue{0x1f, 0x6f, 0xd0},
    green{0x1f, 0x9d, 0x4d}, magenta{0xc0, 0x2a, 0x9a};

/// The usual robot, 260 × 190 × 60 mm.
SimulatedRobot boxRobot(const std::string &name, RgbColour colour, std::shared_ptr<const Motion> motion);

/// Puts a robot into the scene and what is told of it: its colour a bit off, as one picks it, and its height
/// and size where they are told.
void addRobot(AccuracyScene &scene, SeededDraw &draw, const SimulatedRobot &robot, bool hasGivenSize = true);

} // namespace odo::test
