// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/acceptance/scenes/scene_catalogue.h"

#include <string>

namespace odo::test {

/// All that decides what a scene's files hold, as text: files with the same recipe need not be rendered
/// again. A change of the renderer itself is not in it; remove the folder then.
std::string recipeOf(const AccuracyScene &scene);

} // namespace odo::test
