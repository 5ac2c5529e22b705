// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/acceptance/scenes/scene_catalogue.h"
#include "tests/acceptance/scenes/seeded_draw.h"

#include <utility>

namespace odo::test {

/// The scenes with reflections, decoys, occlusion, several robots, a hand-over or a collision.
const std::vector<std::pair<std::string, AccuracyScene (*)(SeededDraw &)>> &hardScenes();

} // namespace odo::test
