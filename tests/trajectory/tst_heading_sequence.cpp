// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/heading_sequence.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace odo;

namespace {

constexpr double framesPerSecond = 30;

/// 3 s of headings with a scatter of 2°, each as a course has it at that time.
std::vector<TimedHeading> measured(const std::function<double(double)> &course)
{
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 0.035);
    std::vector<TimedHeading> headings;
    for (int i = 0; i < 90; ++i) {
        const double timeS = i / framesPerSecond;
        headings.push_back({timeS, course(timeS) + noise(random)});
    }
    return headings;
}

/// Turns at 15 rad/s for 0.4 s, from one frame to the next.
double spin(double timeS)
{
    return 15 * std::clamp(timeS - 1, 0.0, 0.4);
}

double drive(double timeS)
{
    return 0.3 + 0.9 * std::sin(1.5 * timeS);
}

std::vector<std::size_t> allBut(std::size_t count, std::size_t from, std::size_t to)
{
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < count; ++i)
        if (i < from || i >= to)
            indices.push_back(i);
    return indices;
}

} // namespace

class TestHeadingSequence : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatARobotDoesStays_data()
    {
        QTest::addColumn<bool>("isSpinning");
        QTest::newRow("a drive") << false;
        QTest::newRow("a sudden spin") << true;
    }
    void whatARobotDoesStays()
    {
        QFETCH(bool, isSpinning);
        const auto headings = measured(isSpinning ? spin : drive);
        QCOMPARE(headingsInSequence(headings), allBut(90, 0, 0));
    }

    /// An outline shows another side for one frame, or for some.
    void whatLeapsIsLeftOut_data()
    {
        QTest::addColumn<int>("frames");
        QTest::addColumn<double>("byRad");
        for (const int frames : {1, 4, 20})
            for (const double byRad : {0.8, -1.5, std::numbers::pi})
                QTest::addRow("%d frames by %.1f", frames, byRad) << frames << byRad;
    }
    void whatLeapsIsLeftOut()
    {
        QFETCH(int, frames);
        QFETCH(double, byRad);
        auto headings = measured(drive);
        for (std::size_t i = 40; i < 40 + std::size_t(frames); ++i)
            headings[i].radians += byRad;
        // And at most one to each side of them.
        const auto kept = headingsInSequence(headings);
        QVERIFY2(kept.size() >= 88 - std::size_t(frames), qPrintable(QString::number(kept.size())));
        for (const std::size_t i : kept)
            QVERIFY2(i < 40 || i >= 40 + std::size_t(frames), qPrintable(QString::number(i)));
    }

    /// Hidden for half a second it may have turned by anything; with a wrong one at the end of that, too.
    void whatWasHiddenMayHaveTurned()
    {
        auto headings = measured([](double timeS) { return timeS < 1.3 ? 0 : 1.7; });
        headings.erase(headings.begin() + 35, headings.begin() + 50);
        QCOMPARE(headingsInSequence(headings), allBut(75, 0, 0));
        headings[35].radians -= 0.8;
        QCOMPARE(headingsInSequence(headings), allBut(75, 35, 36));
    }

    void whatLeapsForMuchOfTheTimeIsNoHeading()
    {
        auto headings = measured(drive);
        for (std::size_t i = 40; i < 90; ++i)
            headings[i].radians += std::numbers::pi;
        QVERIFY(headingsInSequence(headings).empty());
    }

    void ofFewThereIsNothingToCompare()
    {
        QVERIFY(headingsInSequence({}).empty());
        QCOMPARE(headingsInSequence({{0, 1}}), std::vector<std::size_t>{0});
        QCOMPARE(headingsInSequence({{0, 1}, {1, 1.1}}), (std::vector<std::size_t>{0, 1}));
    }
};

ODOGRAPH_TEST(TestHeadingSequence, QCoreApplication)
#include "tst_heading_sequence.moc"
