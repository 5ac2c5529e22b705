// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>

using namespace odo;

namespace {

std::shared_ptr<const Motion> still()
{
    return makeVelocityMotion({1, 1}, 0, {});
}

/// Whether the boxes that hold two parts share volume. Parts that touch do not.
bool overlap(const RobotPart &a, const RobotPart &b)
{
    return ((a.lower().array() < b.upper().array() - 1e-9) && (b.lower().array() < a.upper().array() - 1e-9))
        .all();
}

} // namespace

class TestDemoRobots : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aColourMakesABox()
    {
        const SimulatedRobot usual = demoRobot("Red 2", {.colour = demoRed}, still());
        QVERIFY(usual.parts.empty());
        QCOMPARE(usual.name, std::string("Red 2"));
        QCOMPARE(usual.colour, demoRed);
        QVERIFY(usual.lengthM == 0.26 && usual.widthM == 0.19 && usual.heightM == 0.06);
        const SimulatedRobot given = demoRobot("Tall", {demoGreen, 0.2, 0.15, 0.3}, still());
        QVERIFY(given.lengthM == 0.2 && given.widthM == 0.15 && given.heightM == 0.3);
    }

    void withoutAColourItIsARover_data()
    {
        QTest::addColumn<double>("lengthM");
        QTest::addColumn<double>("widthM");
        QTest::addColumn<double>("heightM");
        QTest::newRow("usual") << 0.22 << 0.192 << 0.098;
        QTest::newRow("flat and wide") << 0.2 << 0.4 << 0.03;
        QTest::newRow("tall and short") << 0.1 << 0.08 << 0.4;
    }

    void withoutAColourItIsARover()
    {
        QFETCH(double, lengthM);
        QFETCH(double, widthM);
        QFETCH(double, heightM);
        const SimulatedRobot rover = demoRobot("Rover 4", {{}, lengthM, widthM, heightM}, still());
        QVERIFY(std::abs(rover.lengthM - lengthM) < 1e-9 && std::abs(rover.widthM - widthM) < 1e-9);
        QVERIFY(std::abs(rover.heightM - 0.92 * heightM - 0.1) < 1e-9); // the mast's top
        QCOMPARE(std::ranges::count(rover.parts, SimulatedShape::Wheel, &RobotPart::shape), 4);
        for (std::size_t i = 0; i < rover.parts.size(); ++i) {
            QVERIFY((rover.parts[i].sizeM.array() > 0).all() && rover.parts[i].lower().z() > -1e-9);
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY2(!overlap(rover.parts[i], rover.parts[j]),
                         qPrintable(QStringLiteral("parts %1 and %2").arg(i).arg(j)));
        }
    }

    void impossibleSizesAreKeptOnTheFloor()
    {
        const SimulatedRobot huge = demoRobot("Huge", {{}, 10, 10, 10}, still()),
                             tiny = demoRobot("Tiny", {demoRed, 1e-6, 1e-6, 1e-6}, still());
        QVERIFY(std::abs(huge.lengthM - 0.5) < 1e-9 && std::abs(huge.widthM - 0.5) < 1e-9 &&
                huge.heightM < 0.6);
        QVERIFY(tiny.lengthM == 0.03 && tiny.widthM == 0.03 && tiny.heightM == 0.03);
    }

    void noneGivenIsABlueBox()
    {
        const std::vector<SimulatedRobot> robots = circlingRobots({});
        QCOMPARE(robots.size(), std::size_t(1));
        QCOMPARE(robots.front().colour, demoBlue);
        const auto circle = makeCircleMotion({1.5, 1.1}, 0.75, 1.1, 1.5);
        for (const double time : {0.0, 1.0, 3.7, 3600.0})
            QVERIFY((robots.front().motion->at(time).position - circle->at(time).position).norm() < 1e-6);
    }

    void robotsNeverMeet()
    {
        for (std::size_t count = 1; count <= 10; ++count) {
            const std::vector<SimulatedRobot> robots = circlingRobots(std::vector<RobotAppearance>(count));
            QCOMPARE(robots.size(), std::min(count, std::size_t(8)));
            for (double time = 0; time < 6; time += 0.1)
                for (std::size_t i = 0; i < robots.size(); ++i)
                    for (std::size_t j = 0; j < i; ++j)
                        QVERIFY((robots[i].motion->at(time).position - robots[j].motion->at(time).position)
                                    .norm() > std::hypot(0.26, 0.19));
        }
    }
};

ODOGRAPH_TEST(TestDemoRobots, QCoreApplication)
#include "tst_demo_robots.moc"
