// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/acceptance/scenes/scene_catalogue.h"
#include "tests/acceptance/scenes/seeded_draw.h"

#include <utility>

namespace odo::test {

/// Scenes with robots of any look, of which no colour is told: shapes, lights, floors, cameras, and what else
/// moves.
const std::vector<std::pair<std::string, AccuracyScene (*)(SeededDraw &)>> &lookScenes();

} // namespace odo::test
