// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/colour_tracker.h"
#include "tests/support/registered_test.h"
#include "tests/tracking/painter.h"
#include "tests/tracking/tracked_robots.h"

#include <QtTest>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

/// Robots that are hidden or beside others, and pictures without any.
class TestLostRobots : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lossAndFindingAgain();
    void distractorDoesNotCapture();
    void hiddenRobotIsNotReplacedByAReflection();
    void hiddenRobotIsNotReplacedByWhatStoodThere();
    void comesOutWholeWhereItWentInBitByBit_data();
    void comesOutWholeWhereItWentInBitByBit();
    void twoRobots();
    void noRobotInThePicture();
};

void TestLostRobots::lossAndFindingAgain()
{
    const auto tracker = trackerOf({{"r", red}});
    std::mt19937 random(2);
    for (int i = 0; i < 90; ++i) {
        // Behind a board from frame 30 on; comes out elsewhere at frame 60.
        const bool hidden = i >= 30 && i < 60;
        const Vector2d truth = i < 30 ? Vector2d(60 + 2.0 * i, 100) : Vector2d(230, 60 + 1.5 * i);
        Painter painter(testFormat(320, 240));
        if (!hidden)
            painter.disc(truth, 13, red);
        const Observation seen = tracker->track(painter.frame(i, i / 30.0, 2, random)).front();
        QCOMPARE(seen.found, !hidden);
        if (!hidden)
            QVERIFY((seen.ellipse.centrePx - truth).norm() < 0.5);
    }
}

void TestLostRobots::distractorDoesNotCapture()
{
    const auto tracker = trackerOf({{"r", red}});
    std::mt19937 random(4);
    Errors errors;
    for (int i = 0; i < 90; ++i) {
        const Vector2d truth(50 + 2.4 * i, 120);
        Painter painter(testFormat(320, 240));
        painter.rectangle({10, 200}, {300, 208}, red); // tape of the same colour
        painter.disc(truth, 15, red);
        if (i % 20 >= 10)
            painter.disc({truth.x() + 30, truth.y() - 12}, 6, red); // a reflection beside it
        if (i % 15 >= 12)
            painter.disc({160, 60}, 14, red); // a reflection as large as the robot, away from it
        errors.add(tracker->track(painter.frame(i, i / 30.0, 2, random)).front(), truth);
    }
    QCOMPARE(errors.found, errors.frames);
    QVERIFY2(errors.worst < 0.6, qPrintable(QString::number(errors.worst)));
}

void TestLostRobots::hiddenRobotIsNotReplacedByAReflection()
{
    const auto tracker = trackerOf({{"r", red}});
    std::mt19937 random(6);
    for (int i = 0; i < 40; ++i) {
        Painter painter(testFormat(320, 240));
        if (i < 20)
            painter.disc({100.0 + i, 120}, 16, red);
        painter.disc({150, 118}, 5, red);
        const Observation seen = tracker->track(painter.frame(i, i / 30.0, 2, random)).front();
        QCOMPARE(seen.found, i < 20);
    }
}

void TestLostRobots::hiddenRobotIsNotReplacedByWhatStoodThere()
{
    // A cap of the robot's colour lies on the floor; the robot is hidden for three seconds and comes out
    // elsewhere.
    const auto tracker = trackerOf({{"r", red}});
    std::mt19937 random(16);
    for (int i = 0; i < 150; ++i) {
        const bool hidden = i >= 30 && i < 120;
        const Vector2d truth = i < 30 ? Vector2d(70 + 1.5 * i, 120) : Vector2d(250 - 0.5 * (i - 120), 180);
        Painter painter(testFormat(320, 240));
        painter.disc({230, 70}, 16, red);
        if (!hidden)
            painter.disc(truth, 18, red);
        const Observation seen = tracker->track(painter.frame(i, i / 30.0, 2, random)).front();
        QVERIFY2(seen.found == !hidden, qPrintable(QStringLiteral("frame %1").arg(i)));
        if (!hidden)
            QVERIFY((seen.ellipse.centrePx - truth).norm() < 0.5);
    }
}

void TestLostRobots::comesOutWholeWhereItWentInBitByBit_data()
{
    QTest::addColumn<double>("speed"); // px a frame, once it has begun to move
    QTest::newRow("slowly") << 1.5;
    QTest::newRow("quickly") << 4.0;
}

void TestLostRobots::comesOutWholeWhereItWentInBitByBit()
{
    // It goes behind a post until only a sliver is seen, then nothing, and comes out of the other side
    // faster.
    QFETCH(double, speed);
    constexpr double left = 150, right = 190, radius = 16;
    const auto tracker = trackerOf({{"r", red}});
    std::mt19937 random(17);
    double x = left - 2 * radius;
    for (int i = 0; i < 200 && x < 280; ++i) {
        Painter painter(testFormat(320, 240));
        painter.disc({x, 120}, radius, red);
        painter.rectangle({left, 60}, {right, 180}, {120, 96, 70});
        const Observation seen = tracker->track(painter.frame(i, i / 30.0, 2, random)).front();
        if (x - radius > right) {
            QVERIFY2(seen.found, qPrintable(QStringLiteral("frame %1, x %2").arg(i).arg(x)));
            QVERIFY((seen.ellipse.centrePx - Vector2d(x, 120)).norm() < 0.6);
            if (x - radius > right + radius / 2)
                QVERIFY2(seen.score > 0.5, qPrintable(QStringLiteral("frame %1: %2").arg(i).arg(seen.score)));
        }
        x += x < (left + right) / 2 ? speed : 3 * speed;
    }
}

void TestLostRobots::twoRobots()
{
    const RgbColour colours[3] = {red, blue, green};
    const auto tracker = trackerOf({{"a", red}, {"b", blue}, {"c", green}});
    std::mt19937 random(8);
    for (int i = 0; i < 120; ++i) {
        // They cross in the middle, close enough to touch.
        const double t = i / 119.0;
        const Vector2d truth[3] = {{40 + 240 * t, 100}, {280 - 240 * t, 124}, {160, 190 - 150 * t}};
        Painter painter(testFormat(320, 240));
        for (int r = 0; r < 3; ++r)
            painter.disc(truth[r], 12, colours[r]);
        const auto seen = tracker->track(painter.frame(i, i / 30.0, 2, random));
        QCOMPARE(seen.size(), std::size_t(3));
        for (int r = 0; r < 3; ++r) {
            bool covered = false, touched = false;
            for (int other = 0; other < 3; ++other) {
                const double apart = (truth[other] - truth[r]).norm();
                touched |=
                    other != r && apart < 34; // within the reach of the chroma's blur and its references
                covered |= other > r && apart < 26;
            }
            if (!seen[r].found) {
                QVERIFY(covered);
                continue;
            }
            const double error = (seen[r].ellipse.centrePx - truth[r]).norm();
            QVERIFY2(error < (covered   ? 12.0
                              : touched ? 1.5
                                        : 0.3),
                     qPrintable(QStringLiteral("robot %1 frame %2: %3 px").arg(r).arg(i).arg(error)));
        }
    }
}

void TestLostRobots::noRobotInThePicture()
{
    const auto tracker = trackerOf({{"r", red}, {"b", blue}});
    std::mt19937 random(13);
    for (int i = 0; i < 10; ++i) {
        Painter painter(testFormat(320, 240));
        painter.rectangle({30, 30}, {90, 160}, {176, 140, 100});
        painter.rectangle({200, 10}, {208, 220}, red); // tape, no robot
        for (const Observation &seen : tracker->track(painter.frame(i, i / 30.0, 3, random)))
            QVERIFY(!seen.found);
    }
}

ODOGRAPH_TEST(TestLostRobots, QCoreApplication)
#include "tst_lost_robots.moc"
