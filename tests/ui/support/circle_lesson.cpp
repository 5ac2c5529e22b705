// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/circle_lesson.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "tests/support/simulated_set_up.h"

#include <QTest>

namespace odo::test {

void addCircleLesson(Project &project)
{
    const SimulatedScene testbed = demoTestbed(1);
    const RecordId layout = project.layouts().add(testbed.floor.markers)->id;
    for (const SimulatedCamera &camera : testbed.cameras)
        QVERIFY(registerSimulatedCamera(project, camera, testbed.floor.markers, layout));
    for (const DemoTrial &trial : demoTrials()) {
        if (trial.trial == "circle")
            QVERIFY(addSimulatedRobot(project, trial.scene.robots.front()));
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
