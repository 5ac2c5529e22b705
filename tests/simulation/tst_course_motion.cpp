// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/course_motion.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace odo;
using Eigen::Vector2d;

class TestCourseMotion : public QObject
{
    Q_OBJECT

    static std::vector<Vector2d> circle(double radiusM)
    {
        constexpr int count = 720;
        std::vector<Vector2d> points;
        for (int i = 0; i <= count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            points.push_back(Vector2d(1, 1) + radiusM * Vector2d(std::cos(angle), std::sin(angle)));
        }
        return points;
    }

private Q_SLOTS:
    void derivativesAreExact_data()
    {
        QTest::addColumn<std::vector<Vector2d>>("points");
        QTest::newRow("line") << std::vector<Vector2d>{{0, 0}, {2, 0.5}};
        QTest::newRow("square with stops") << std::vector<Vector2d>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
        QTest::newRow("circle") << circle(0.6);
        QTest::newRow("short") << std::vector<Vector2d>{{0, 0}, {0.03, 0}};
    }
    void derivativesAreExact()
    {
        QFETCH(const std::vector<Vector2d>, points);
        const CourseRun run = driveCourse(points, {});
        // Central differences with a step of 1e-4 s: the third and fourth derivatives of ramps of 0.7 s up to
        // 1 m/s stay below 20 m/s³ and 200 m/s⁴, so they are off by less than 1e-7; where pieces of the
        // spline meet, the jump of the third derivative counts, 20 m/s³ · h.
        const double h = 1e-4;
        for (double t = -0.2; t < run.durationS + 0.5; t += 0.0137) {
            const MotionState before = run.motion->at(t - h), at = run.motion->at(t),
                              after = run.motion->at(t + h);
            const Vector2d velocity = (after.position - before.position) / (2 * h);
            const Vector2d acceleration = (after.velocity - before.velocity) / (2 * h);
            QVERIFY2((velocity - at.velocity).norm() < 1e-6, qPrintable(QString::number(t)));
            QVERIFY2((acceleration - at.acceleration).norm() < 4e-3, qPrintable(QString::number(t)));
            QVERIFY2(std::abs(std::remainder(after.headingRad - before.headingRad, 2 * std::numbers::pi)) <
                         20 * h,
                     qPrintable(QString::number(t)));
        }
    }
    void aStraightLineIsTheClosedForm()
    {
        // Twice a ramp of 0.7 s, each half as long as driving evenly: 2 m at 1 m/s take 2.7 s.
        const CourseRun run = driveCourse({{0, 0}, {2, 0}}, {});
        QVERIFY(std::abs(run.durationS - (0.6 + 2.7 + 0.6)) < 1e-9);
        QVERIFY(std::abs(run.lengthM - 2) < 1e-9);
        QVERIFY(std::abs(run.topSpeedMps - 1) < 1e-9);
        const MotionState middle = run.motion->at(0.6 + 1.35);
        QVERIFY((middle.position - Vector2d(1, 0)).norm() < 1e-9);
        QVERIFY((middle.velocity - Vector2d(1, 0)).norm() < 1e-9);
        QVERIFY(middle.acceleration.norm() < 1e-9);
        QVERIFY(run.motion->at(0).position.norm() < 1e-12);
        QVERIFY((run.motion->at(100).position - Vector2d(2, 0)).norm() < 1e-9);
        QCOMPARE(run.corners.size(), std::size_t(2));
    }
    /// The spline through a point every 0.1 m leaves a circle of 0.6 m by about h⁴/(384 r³), 1.2 µm; the
    /// points are on chords of half a degree, up to 6 µm inside.
    void aCurveIsFollowedWithinItsLimit()
    {
        CourseDriving driving;
        driving.accelMps2 = 0.6;
        const CourseRun run = driveCourse(circle(0.6), driving);
        // v² / r = 0.6: 0.6 m/s; the spline's curvature is nearly the circle's
        QVERIFY2(std::abs(run.topSpeedMps - 0.6) < 0.02, qPrintable(QString::number(run.topSpeedMps)));
        QVERIFY(std::abs(run.lengthM - 2 * std::numbers::pi * 0.6) < 0.005);
        for (double t = 0; t < run.durationS; t += 0.05)
            QVERIFY(std::abs((run.motion->at(t).position - Vector2d(1, 1)).norm() - 0.6) < 3e-4);
        QCOMPARE(run.corners.size(), std::size_t(2)); // nowhere a stop
    }
    void itTurnsAtCornersAndStandsThere()
    {
        const CourseRun run = driveCourse({{0, 0}, {1, 0}, {1, 1}}, {});
        QCOMPARE(run.corners.size(), std::size_t(3));
        const double arrivesS = 0.6 + 1.7, leavesS = arrivesS + 0.6;
        for (double t = arrivesS; t < leavesS; t += 0.05) {
            QVERIFY((run.motion->at(t).position - Vector2d(1, 0)).norm() < 1e-9);
            QVERIFY(run.motion->at(t).velocity.norm() < 1e-9);
        }
        QVERIFY(std::abs(run.motion->at(arrivesS).headingRad) < 1e-9);
        QVERIFY(std::abs(run.motion->at(arrivesS + 0.3).headingRad - std::numbers::pi / 4) < 1e-9);
        QVERIFY(std::abs(run.motion->at(leavesS).headingRad - std::numbers::pi / 2) < 1e-9);
    }
    void doubledPointsAndALimitOfLength()
    {
        CourseDriving driving;
        driving.longestM = 1.5;
        const CourseRun run = driveCourse({{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1}, {1, 9}}, driving);
        QVERIFY(std::abs(run.lengthM - 1.5) < 1e-9);
        QVERIFY((run.motion->at(run.durationS).position - Vector2d(1, 0.5)).norm() < 1e-9);
    }
};

ODOGRAPH_TEST(TestCourseMotion, QCoreApplication)
#include "tst_course_motion.moc"
