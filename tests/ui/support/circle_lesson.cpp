// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/circle_lesson.h"

#include "core/calibration/floor_registration.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/workflow/stored_registration.h"

#include <QTest>

namespace odo::test {
namespace {

void registerCamera(Project &project, const SimulatedCamera &camera, RecordId layout)
{
    const MarkerLayout places = project.layouts().get(layout)->layout;
    RegistrationRecord record;
    record.layout = layout;
    record.assumedIntrinsics = camera.view.camera().intrinsics();
    for (const Marker &marker : places.markers)
        record.pixels.push_back({marker.label, *camera.view.pixelFromWorld(
                                                   {marker.pointInWorld.x(), marker.pointInWorld.y(), 0})});
    record.registration = *registerFloor(places, record.pixels, camera.view.camera(), true);
    QVERIFY(storeRegistration(project, camera.name, record));
}

} // namespace

void addCircleLesson(Project &project)
{
    const SimulatedScene testbed = demoTestbed(1);
    const RecordId layout = project.layouts().add(testbed.floor.markers)->id;
    for (const SimulatedCamera &camera : testbed.cameras)
        registerCamera(project, camera, layout);
    for (const DemoTrial &trial : demoTrials()) {
        if (trial.trial != "circle")
            continue;
        RobotRecord robot;
        robot.name = trial.robot;
        robot.colour = trial.scene.robots.front().colour;
        robot.heightMode = RobotRecord::Height::Told;
        robot.heightM = trial.scene.robots.front().heightM;
        QVERIFY(project.robots().add(robot));
    }
    for (const char *team : {"Falcon", "Otter"})
        QVERIFY(project.teams().add({0, team, "9A"}));
    Task lap;
    lap.kind = TaskTemplate::Circle;
    lap.gates = {gateAcross("Lap", GateRole::StartFinish, circleMiddle + Eigen::Vector2d(0, circleRadiusM),
                            {-1, 0}, 0.4)};
    QVERIFY(project.tasks().add({0, "Circle", lap}));
}

} // namespace odo::test
