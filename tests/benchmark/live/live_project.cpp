// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/live/live_project.h"

#include "core/project/repositories.h"
#include "tests/support/simulated_set_up.h"

namespace odo::test {

Result<std::unique_ptr<Project>> makeLiveProject(const std::filesystem::path &file,
                                                 const SimulatedScene &scene, bool isColourGiven)
{
    auto project = Project::create(file, "Live");
    if (!project)
        return project;
    const auto layout = (*project)->layouts().add(scene.floor.markers);
    if (!layout)
        return tl::unexpected(layout.error());
    for (const SimulatedCamera &camera : scene.cameras) {
        if (const auto stored = registerSimulatedCamera(**project, camera, scene.floor.markers, layout->id);
            !stored)
            return tl::unexpected(stored.error());
    }
    for (const SimulatedRobot &robot : scene.robots) {
        if (const auto added = addSimulatedRobot(**project, robot, isColourGiven); !added)
            return tl::unexpected(added.error());
    }
    return project;
}

} // namespace odo::test
