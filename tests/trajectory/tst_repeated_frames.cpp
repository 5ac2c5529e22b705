// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/floor_positions.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <random>

using namespace odo;

namespace {

/// A robot that moves by 3 px a frame, turning slowly, measured to 0.02 px.
std::vector<Observation> run(int frames)
{
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 0.02);
    std::vector<Observation> all;
    for (int i = 0; i < frames; ++i) {
        Observation observation;
        observation.found = true;
        observation.frame = i;
        observation.time = fromSeconds(i / 30.0);
        observation.ellipse.centrePx = {600 + 60 * std::sin(0.05 * i) + noise(random),
                                        300 + 60 * std::cos(0.05 * i) + noise(random)};
        all.push_back(observation);
    }
    return all;
}

void repeat(std::vector<Observation> &all, std::size_t i)
{
    all[i].ellipse.centrePx = all[i - 1].ellipse.centrePx + Eigen::Vector2d(0.01, -0.01);
}

std::vector<std::size_t> indices(const std::vector<bool> &flags)
{
    std::vector<std::size_t> set;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i])
            set.push_back(i);
    }
    return set;
}

} // namespace

class TestRepeatedFrames : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneAndSeveralInARowAreFound()
    {
        auto all = run(100);
        repeat(all, 20);
        repeat(all, 50);
        repeat(all, 51);
        QCOMPARE(indices(repeatedFrames(all)), (std::vector<std::size_t>{20, 50, 51}));
    }

    void anHonestRunHasNone() { QVERIFY(indices(repeatedFrames(run(200))).empty()); }

    void aRobotThatRestsAndGoesOnRepeatsNothing()
    {
        // It stops for two frames and goes on from there: nothing is caught up.
        auto all = run(100);
        const Eigen::Vector2d rest = all[40].ellipse.centrePx;
        const Eigen::Vector2d lost = all[42].ellipse.centrePx - rest;
        all[41].ellipse.centrePx = all[42].ellipse.centrePx = rest;
        for (std::size_t i = 43; i < all.size(); ++i)
            all[i].ellipse.centrePx -= lost;
        QVERIFY(indices(repeatedFrames(all)).empty());
    }

    void aRobotAtRestRepeatsNothing()
    {
        auto all = run(50);
        for (Observation &observation : all)
            observation.ellipse.centrePx = {600, 300};
        QVERIFY(indices(repeatedFrames(all)).empty());
    }

    void theEndsAndGapsAreLeftAlone()
    {
        auto all = run(30);
        repeat(all, 1);
        repeat(all, 29);
        all[14].found = false;
        repeat(all, 16);
        QVERIFY(indices(repeatedFrames(all)).empty());
        QVERIFY(repeatedFrames({}).empty());
    }
};

ODOGRAPH_TEST(TestRepeatedFrames, QCoreApplication)
#include "tst_repeated_frames.moc"
