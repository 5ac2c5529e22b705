// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "tests/support/registered_test.h"
#include "tests/workflow/measured_scene.h"

#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <QTest>
#include <numbers>

using namespace odo;
using namespace odo::test;

namespace {

SimulatedScene robotOnCircle()
{
    SimulatedScene scene = demoTestbed(51);
    scene.durationS = 4;
    scene.robots = {demoRobot("robot", {.colour = demoBlue}, makeCircleMotion({1.5, 1.1}, 0.7, 0.7, 0.6))};
    return scene;
}

/// Its height is told: an unknown solid could explain a part of what the views are apart.
RobotRecord told()
{
    RobotRecord robot;
    robot.name = "robot";
    robot.colour = demoBlue;
    robot.heightMode = RobotRecord::Height::Given;
    robot.heightM = 0.06;
    return robot;
}

/// As registered before the camera was turned by an angle about the vertical, with what a registration leaves
/// open.
FloorView registeredBefore(const FloorView &now, double turnRad)
{
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
    constexpr double angleRad = 2e-4, stationM = 5e-4;
    covariance.diagonal() << Eigen::Vector3d::Constant(angleRad * angleRad),
        Eigen::Vector3d::Constant(stationM * stationM);
    RigidTransform pose = now.worldFromCamera();
    pose.rotation = Eigen::AngleAxisd(turnRad, Eigen::Vector3d::UnitZ()) * pose.rotation;
    return {now.camera(), pose, covariance};
}

} // namespace

class TestMovedCamera : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// The stated error holds the truth, and it is said that the views contradict one another.
    void whatACameraWasTurnedByIsInTheError()
    {
        const SimulatedScene scene = robotOnCircle();
        const QTemporaryDir folder;
        auto views = renderedViews(scene, folder.path().toStdString());
        QVERIFY2(views.has_value(), views ? "" : views.error().message().c_str());
        for (std::size_t v = 0; v < views->size(); ++v)
            (*views)[v].floorView = registeredBefore(scene.cameras[v].view, 0);
        const FloorView truth = *(*views)[0].floorView;
        for (const double turnDegrees : {0.0, 0.2, 0.5, 1.0}) {
            (*views)[0].floorView = registeredBefore(truth, turnDegrees * std::numbers::pi / 180);
            const auto metrics = measuredByViews(scene, *views, told());
            QVERIFY2(metrics.has_value(), metrics ? "" : metrics.error().message().c_str());
            QVERIFY2(metrics->insideShare > 0.9 && metrics->foundShare > 0.99 && metrics->spikes <= 5,
                     qPrintable(metrics->words()));
            QVERIFY2(turnDegrees == 0 ? metrics->disagreeShare < 0.01 && metrics->rmsM < 0.003
                                      : metrics->disagreeShare > 0.9,
                     qPrintable(metrics->words()));
        }
    }
};

ODOGRAPH_TEST(TestMovedCamera, QCoreApplication)
#include "tst_moved_camera.moc"
