// SPDX-License-Identifier: GPL-3.0-or-later
// Robots that turn on the spot and reverse, from the videos to the heading of their body.
#include "core/simulation/demo_testbed.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/driven_course.h"
#include "tests/workflow/measured_scene.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

using Vector = Eigen::Vector3d;

class DrivenMotion : public Motion
{
public:
    MotionState at(double timeS) const override
    {
        constexpr double halfS = 1e-3;
        const DrivenState state = m_course.at(timeS);
        return {state.truth.position + Eigen::Vector2d(1.5, 1.0), state.truth.velocity,
                (m_course.at(timeS + halfS).truth.velocity - m_course.at(timeS - halfS).truth.velocity) /
                    (2 * halfS),
                *state.truth.headingRad};
    }

private:
    DrivenCourse m_course = spinsAndReverses();
};

SimulatedRobot rover()
{
    SimulatedRobot robot;
    robot.heightM = 0.11;
    const auto add = [&robot](SimulatedShape shape, RgbColour colour, Vector centre, Vector size) {
        robot.parts.push_back({shape, colour, std::move(centre), std::move(size)});
    };
    add(SimulatedShape::Box, {60, 60, 66}, {0, 0, 0.041}, {0.24, 0.14, 0.038});
    add(SimulatedShape::Box, {225, 225, 220}, {-0.03, 0, 0.085}, {0.11, 0.1, 0.05});
    for (const double x : {0.075, -0.075})
        for (const double y : {0.085, -0.085})
            add(SimulatedShape::Wheel, {28, 28, 30}, {x, y, 0.034}, {0.068, 0.028, 0.068});
    return robot;
}

SimulatedRobot plain(SimulatedShape shape, double lengthM, double widthM)
{
    SimulatedRobot robot;
    robot.shape = shape;
    robot.lengthM = lengthM;
    robot.widthM = widthM;
    robot.heightM = 0.08;
    robot.colour = {60, 60, 66};
    return robot;
}

} // namespace

class TestTurningRobots : public QObject
{
    Q_OBJECT

    static Result<SceneMetrics> measured(SimulatedRobot robot)
    {
        SimulatedScene scene = demoTestbed(77);
        scene.durationS = 10;
        robot.name = "R";
        robot.motion = std::make_shared<DrivenMotion>();
        scene.robots = {std::move(robot)};
        return measuredScene(scene);
    }

private Q_SLOTS:
    void aBodyIsFollowed_data()
    {
        QTest::addColumn<int>("robot");
        QTest::newRow("rover with wheels") << 0;
        QTest::newRow("box") << 1;
        QTest::newRow("box that is wider than long") << 2;
    }
    void aBodyIsFollowed()
    {
        QFETCH(int, robot);
        const SimulatedRobot robots[] = {rover(), plain(SimulatedShape::Box, 0.24, 0.16),
                                         plain(SimulatedShape::Box, 0.14, 0.22)};
        const auto metrics = measured(robots[robot]);
        QVERIFY2(metrics.has_value(), metrics ? "" : metrics.error().message().c_str());
        qInfo("%s", qPrintable(metrics->words()));
        QVERIFY2(metrics->bodyShare > 0.95 && metrics->headingInside > 0.9 && metrics->turnRateInside > 0.9,
                 qPrintable(metrics->words()));
        QVERIFY(metrics->fastestTurn && *metrics->fastestTurn->sigma < 1);
        QVERIFY2(std::abs(metrics->fastestTurn->value - 4) < 2 * *metrics->fastestTurn->sigma,
                 qPrintable(metrics->words()));
    }
    void aRoundRobotHasADirectionOfMotion()
    {
        const auto metrics = measured(plain(SimulatedShape::Cylinder, 0.2, 0.2));
        QVERIFY2(metrics.has_value(), metrics ? "" : metrics.error().message().c_str());
        qInfo("%s", qPrintable(metrics->words()));
        QCOMPARE(metrics->bodyShare, 0.0);
    }
};

ODOGRAPH_TEST(TestTurningRobots, QCoreApplication)
#include "tst_turning_robots.moc"
