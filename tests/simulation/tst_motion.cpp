// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/motion.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>

using namespace odo;

namespace {

using Shared = std::shared_ptr<const Motion>;

struct Case
{
    const char *name;
    Shared motion;
    double endS;
};

std::vector<Case> cases()
{
    return {{"line", makeLineMotion({0.2, 0.3}, {2.5, 1.4}, 0.5, 2.5), 4.0},
            {"circle", makeCircleMotion({1.5, 1.1}, 0.7, 1.3, 1.0), 6.0},
            {"figure eight", makeFigureEightMotion({1.5, 1.1}, 1.0, 0.6, 5.0, 1.2), 7.0},
            {"stop and go", makeStopAndGoMotion({{0, 0}, {2, 0}, {2, 1}, {0.5, 1.5}}, 1.5, 0.5), 8.0},
            {"spline", makeSplineMotion({{0, 0}, {1, 0.3}, {1.4, 1.2}, {0.3, 1.6}, {0.1, 0.4}}, 0.9), 5.0},
            {"ellipse", makeEllipseMotion({1.5, 1.1}, 0.9, 0.5, 4.0, 2.0, 1.0), 6.0},
            // The ramp of 1.5 m/s over 0.4 s: a jerk of 5.8 · 1.5/0.4² = 54 m/s³ at most.
            {"velocities",
             makeVelocityMotion({0.2, 0.3}, 0.1,
                                {{0.5, 0.8, {1.0, 0.2}}, {1.2, 0.4, {-1.5, 0}}, {3, 0.5, {0.5, 0.1}}}),
             5.0}};
}

} // namespace

class TestMotion : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void derivativesAreExact_data() { addCases(); }
    void derivativesAreExact()
    {
        QFETCH(Shared, motion);
        QFETCH(double, endS);
        // Central differences: the third derivative of these motions stays below 300 m/s³ and the fourth
        // below 6000 m/s⁴, so a step of 1e-4 s is off by h²/6 of those, at most 5e-7 m/s and 1e-5 m/s².
        const double h = 1e-4;
        for (double t = -0.5; t < endS; t += 0.0137) {
            const MotionState before = motion->at(t - h), at = motion->at(t), after = motion->at(t + h);
            const Eigen::Vector2d velocity = (after.position - before.position) / (2 * h);
            const Eigen::Vector2d acceleration = (after.velocity - before.velocity) / (2 * h);
            // Where two pieces meet inside the difference only the jerk's jump matters: 300 m/s³ · h.
            QVERIFY2((velocity - at.velocity).norm() < 2e-6, qPrintable(QStringLiteral("v at %1 s").arg(t)));
            QVERIFY2((acceleration - at.acceleration).norm() < 0.03,
                     qPrintable(QStringLiteral("a at %1 s").arg(t)));
        }
    }

    void isTwiceContinuous_data() { addCases(); }
    void isTwiceContinuous()
    {
        QFETCH(Shared, motion);
        QFETCH(double, endS);
        // Over a microsecond nothing may change by more than its derivative allows (jerk below 300 m/s³).
        for (double t = -0.1; t < endS; t += 0.001) {
            const MotionState a = motion->at(t), b = motion->at(t + 1e-6);
            QVERIFY2((b.position - a.position).norm() < 1e-5, qPrintable(QStringLiteral("p at %1 s").arg(t)));
            QVERIFY2((b.velocity - a.velocity).norm() < 1e-4, qPrintable(QStringLiteral("v at %1 s").arg(t)));
            QVERIFY2((b.acceleration - a.acceleration).norm() < 3e-4,
                     qPrintable(QStringLiteral("a at %1 s").arg(t)));
        }
    }

    void anImpactThrowsBack()
    {
        // 1 m/s from 0.9 s on, after half of the ramp's way; thrown back at 0.3 m/s within 30 ms at 2 s.
        const Shared motion = makeVelocityMotion({0, 0}, 0, {{0.5, 0.4, {1, 0}}, {1.985, 0.03, {-1.3, 0}}});
        QVERIFY((motion->at(1.5).position - Eigen::Vector2d(0.8, 0)).norm() < 1e-12);
        QVERIFY((motion->at(1.98).velocity - Eigen::Vector2d(1, 0)).norm() < 1e-12);
        QVERIFY((motion->at(2.1).velocity - Eigen::Vector2d(-0.3, 0)).norm() < 1e-12);
        // As far forth and back as if it were thrown back at once in the middle of the contact.
        QVERIFY((motion->at(3.0).position - Eigen::Vector2d(1.3 - 0.3, 0)).norm() < 1e-12);
        QCOMPARE(motion->at(3.0).headingRad, 0.0);
    }

    void joinsWithoutAJump_data()
    {
        QTest::addColumn<Shared>("motion");
        QTest::addColumn<double>("jointS");
        const auto all = cases();
        QTest::newRow("line starts") << all[0].motion << 0.5;
        QTest::newRow("line ends") << all[0].motion << 3.0;
        QTest::newRow("circle starts") << all[1].motion << 0.0;
        QTest::newRow("circle is up to speed") << all[1].motion << 1.0;
        QTest::newRow("eight is up to speed") << all[2].motion << 1.2;
        QTest::newRow("stops") << all[3].motion << 2.0;
        QTest::newRow("goes on") << all[3].motion << 2.5;
        QTest::newRow("spline starts") << all[4].motion << 0.0;
        QTest::newRow("spline knot") << all[4].motion << 1.8;
        QTest::newRow("spline ends") << all[4].motion << 3.6;
    }
    void joinsWithoutAJump()
    {
        QFETCH(Shared, motion);
        QFETCH(double, jointS);
        const double h = 1e-8;
        const MotionState before = motion->at(jointS - h), after = motion->at(jointS + h);
        QVERIFY((after.position - before.position).norm() < 1e-6);
        QVERIFY((after.velocity - before.velocity).norm() < 1e-5);
        QVERIFY((after.acceleration - before.acceleration).norm() < 1e-4);
    }

    void headsAlongItsVelocity_data()
    {
        QTest::addColumn<Shared>("motion");
        QTest::addColumn<double>("endS");
        for (const Case &test : cases())
            if (QByteArray(test.name) != "velocities") // keeps its heading
                QTest::newRow(test.name) << test.motion << test.endS;
    }
    void headsAlongItsVelocity()
    {
        QFETCH(Shared, motion);
        QFETCH(double, endS);
        int moving = 0;
        for (double t = 0; t < endS; t += 0.01) {
            const MotionState state = motion->at(t);
            if (state.velocity.norm() < 1e-3)
                continue;
            ++moving;
            const double direction = std::atan2(state.velocity.y(), state.velocity.x());
            QVERIFY(std::abs(std::remainder(direction - state.headingRad, 2 * std::numbers::pi)) < 1e-9);
        }
        QVERIFY(moving > 100);
    }

    void goesWhereItIsTold()
    {
        const auto all = cases();
        QVERIFY((all[0].motion->at(-1).position - Eigen::Vector2d(0.2, 0.3)).norm() < 1e-15);
        QVERIFY((all[0].motion->at(9).position - Eigen::Vector2d(2.5, 1.4)).norm() < 1e-14);
        // A quintic ramp is fastest in its middle: 15/8 of its mean speed.
        const double mean = Eigen::Vector2d(2.3, 1.1).norm() / 2.5;
        QVERIFY(std::abs(all[0].motion->at(1.75).velocity.norm() - 1.875 * mean) < 1e-12);

        const MotionState circling = all[1].motion->at(4.0);
        QVERIFY(std::abs((circling.position - Eigen::Vector2d(1.5, 1.1)).norm() - 0.7) < 1e-12);
        QVERIFY(std::abs(circling.velocity.norm() - 1.3) < 1e-12);
        QVERIFY(std::abs(circling.acceleration.norm() - 1.3 * 1.3 / 0.7) < 1e-12);
        QVERIFY(circling.velocity.dot(circling.position - Eigen::Vector2d(1.5, 1.1)) < 1e-12);

        // Pause 0.5, leg 1.5: at the second way point from 2.0 to 2.5 s, turned by then.
        QVERIFY((all[3].motion->at(2.2).position - Eigen::Vector2d(2, 0)).norm() < 1e-15);
        QVERIFY(std::abs(all[3].motion->at(2.0).headingRad) < 1e-12);
        QVERIFY(std::abs(all[3].motion->at(2.5).headingRad - std::numbers::pi / 2) < 1e-12);
        QVERIFY((all[3].motion->at(99).position - Eigen::Vector2d(0.5, 1.5)).norm() < 1e-14);

        const Eigen::Vector2d knots[] = {{0, 0}, {1, 0.3}, {1.4, 1.2}, {0.3, 1.6}, {0.1, 0.4}};
        for (int i = 0; i < 5; ++i)
            QVERIFY((all[4].motion->at(0.9 * i).position - knots[i]).norm() < 1e-12);
        QVERIFY(all[4].motion->at(-1).velocity.norm() < 1e-12 &&
                all[4].motion->at(5).velocity.norm() < 1e-12);
    }

private:
    static void addCases()
    {
        QTest::addColumn<Shared>("motion");
        QTest::addColumn<double>("endS");
        for (const Case &c : cases())
            QTest::newRow(c.name) << c.motion << c.endS;
    }
};

ODOGRAPH_TEST(TestMotion, QCoreApplication)
#include "tst_motion.moc"
