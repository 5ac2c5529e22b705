// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/simulated_set_up.h"

#include "core/calibration/floor_registration.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"

namespace odo::test {

Result<void> registerSimulatedCamera(Project &project, const SimulatedCamera &camera,
                                     const MarkerLayout &places, RecordId layout)
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
    if (const auto stored = storeRegistration(project, camera.name, record); !stored)
        return tl::unexpected(stored.error());
    return project.cameras().find(camera.name).and_then([&](const CameraRecord &stored) {
        return project.cameras().setDevice(stored.id, "sim:" + camera.name);
    });
}

Result<void> addSimulatedRobot(Project &project, const SimulatedRobot &seen, bool isColourGiven)
{
    RobotRecord robot;
    robot.name = seen.name;
    if (isColourGiven)
        robot.colour = seen.colour;
    robot.heightMode = RobotRecord::Height::Given;
    robot.heightM = seen.heightM;
    return project.robots().add(robot).map([](const auto &) {});
}

} // namespace odo::test
