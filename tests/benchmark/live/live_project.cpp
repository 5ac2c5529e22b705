// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/live/live_project.h"

#include "core/calibration/floor_registration.h"
#include "core/project/repositories.h"
#include "core/workflow/stored_registration.h"

namespace odo::test {

namespace {

Result<void> registerCamera(Project &project, const SimulatedCamera &camera, const MarkerLayout &places,
                            RecordId layout)
{
    RegistrationRecord record;
    record.layout = layout;
    record.assumedIntrinsics = camera.view.camera().intrinsics();
    for (const Marker &marker : places.markers)
        record.pixels.push_back({marker.label, *camera.view.pixelFromWorld(
                                                   {marker.pointInWorld.x(), marker.pointInWorld.y(), 0})});
    auto registration = registerFloor(places, record.pixels, camera.view.camera(), true);
    if (!registration)
        return tl::unexpected(registration.error());
    record.registration = std::move(*registration);
    return storeRegistration(project, camera.name, record).map([](const auto &) {});
}

Result<void> addRobot(Project &project, const SimulatedRobot &seen)
{
    RobotRecord robot;
    robot.name = seen.name;
    robot.colour = seen.colour;
    robot.heightMode = RobotRecord::Height::Told;
    robot.heightM = seen.heightM;
    return project.robots().add(robot).map([](const auto &) {});
}

} // namespace

Result<std::unique_ptr<Project>> makeLiveProject(const std::filesystem::path &file,
                                                 const SimulatedScene &scene)
{
    auto project = Project::create(file, "Live");
    if (!project)
        return project;
    const auto layout = (*project)->layouts().add(scene.floor.markers);
    if (!layout)
        return tl::unexpected(layout.error());
    for (const SimulatedCamera &camera : scene.cameras) {
        if (const auto stored = registerCamera(**project, camera, scene.floor.markers, layout->id); !stored)
            return tl::unexpected(stored.error());
    }
    for (const SimulatedRobot &robot : scene.robots) {
        if (const auto added = addRobot(**project, robot); !added)
            return tl::unexpected(added.error());
    }
    return project;
}

} // namespace odo::test
