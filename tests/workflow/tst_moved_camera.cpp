// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/wheeled_body.h"
#include "tests/workflow/measured_scene.h"

#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <QTest>
#include <numbers>

using namespace odo;
using namespace odo::test;

namespace {

SimulatedScene roverOnCircle()
{
    SimulatedScene scene = demoTestbed(51);
    scene.durationS = 4;
    std::vector<RobotPart> parts{{SimulatedShape::Box, {200, 60, 50}, {0, 0, 0.05}, {0.22, 0.14, 0.05}}};
    scene.robots = {robotOfParts("robot", onFourWheels(std::move(parts), {28, 28, 30}, 0.07, 0.085, 0.03, 0.028), makeCircleMotion({1.5, 1.1}, 0.7, 0.7, 0.6))};
    return scene;
}

/// As registered before the camera was turned by an angle about the vertical, with what a registration leaves open.
FloorView registeredBefore(const FloorView &now, double turnRad)
{
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
    constexpr double angleRad = 2e-4, placeM = 5e-4;
    covariance.diagonal() << Eigen::Vector3d::Constant(angleRad * angleRad), Eigen::Vector3d::Constant(placeM * placeM);
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
        const SimulatedScene scene = roverOnCircle();
        const QTemporaryDir folder;
        auto views = renderedViews(scene, folder.path().toStdString());
        QVERIFY2(views.has_value(), views ? "" : views.error().message().c_str());
        for (std::size_t v = 0; v < views->size(); ++v)
            (*views)[v].floorView = registeredBefore(scene.cameras[v].view, 0);
        const FloorView truth = *(*views)[0].floorView;
        for (const double turnDegrees : {0.0, 0.2, 0.5, 1.0}) {
            (*views)[0].floorView = registeredBefore(truth, turnDegrees * std::numbers::pi / 180);
            const auto figures = measuredByViews(scene, *views);
            QVERIFY2(figures.has_value(), figures ? "" : figures.error().message().c_str());
            QVERIFY2(figures->insideShare > 0.9 && figures->foundShare > 0.99 && figures->spikes <= 2, qPrintable(figures->words()));
            QVERIFY2(turnDegrees == 0 ? figures->disagreeShare < 0.01 && figures->rmsM < 0.003 : figures->disagreeShare > 0.9, qPrintable(figures->words()));
        }
    }

    /// So far that hardly a robot's length of it is common: then that is the reason.
    void aCameraThatWasTurnedFarIsRefused()
    {
        const SimulatedScene scene = roverOnCircle();
        const QTemporaryDir folder;
        auto views = renderedViews(scene, folder.path().toStdString());
        QVERIFY2(views.has_value(), views ? "" : views.error().message().c_str());
        (*views)[0].floorView = registeredBefore(scene.cameras[0].view, 0.2);
        const auto figures = measuredByViews(scene, *views);
        QVERIFY(!figures);
        QVERIFY2(figures.error().why.starts_with("the views put it ") && figures.error().why.find("a camera was moved") != std::string::npos, figures.error().message().c_str());
    }
};

QTEST_GUILESS_MAIN(TestMovedCamera)
#include "tst_moved_camera.moc"
