// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/simulation/scene.h"

#include <filesystem>

namespace odo::test {

/// A project with the floor, the cameras (registered by the markers' true pixels) and the robots of a scene.
/// isColourGiven: whether the robots are followed by their colours; otherwise by their silhouettes.
Result<std::unique_ptr<Project>> makeLiveProject(const std::filesystem::path &file,
                                                 const SimulatedScene &scene, bool isColourGiven);

} // namespace odo::test
