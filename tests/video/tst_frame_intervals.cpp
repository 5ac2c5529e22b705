// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals between frames: against what was put into them.
#include "core/video/frame_intervals.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

std::int64_t countOf(const FrameIntervals &intervals)
{
    return std::accumulate(intervals.bins.begin(), intervals.bins.end(), intervals.longer,
                           [](std::int64_t sum, const IntervalBin &bin) { return sum + bin.count; });
}

} // namespace

class TestFrameIntervals : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void evenFramesAreInOneBin()
    {
        const FrameIntervals even = frameIntervals(evenTimes(251, 25));
        QCOMPARE(even.count, 250);
        QCOMPARE(even.usual, Nanoseconds(40ms));
        QCOMPARE(even.jitterS, 0.0);
        QCOMPARE(even.missing, 0);
        QVERIFY(even.bins.front().from <= 36ms && even.bins.back().to >= 44ms);
        const auto filled = std::ranges::find(even.bins, 250, &IntervalBin::count);
        QVERIFY(filled != even.bins.end() && filled->from <= 40ms && 40ms < filled->to);
        QCOMPARE(countOf(even), 250);
    }
    void lostFramesAreCounted()
    {
        std::vector<Nanoseconds> times = evenTimes(300, 50);
        times.erase(times.begin() + 200, times.begin() + 210); // ten at once
        times.erase(times.begin() + 100);
        times.erase(times.begin() + 50, times.begin() + 52);
        const FrameIntervals intervals = frameIntervals(times);
        QCOMPARE(intervals.gaps, 3);
        QCOMPARE(intervals.missing, 13);
        QCOMPARE(intervals.usual, Nanoseconds(20ms));
        QVERIFY(intervals.jitterS < 1e-6);
        QCOMPARE(intervals.longest, Nanoseconds(220ms));
        QCOMPARE(intervals.longer, 1); // than 90 ms
        QCOMPARE(countOf(intervals), intervals.count);
    }
    void jitterIsTheScatter()
    {
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0, 0.0015);
        std::vector<Nanoseconds> times{Nanoseconds(0)};
        for (int i = 1; i < 4001; ++i) // each interval by itself
            times.push_back(times.back() + fromSeconds(1.0 / 30 + noise(random)));
        const FrameIntervals intervals = frameIntervals(times);
        QVERIFY(std::abs(intervals.jitterS - 0.0015) < 4 * intervals.jitterSigmaS);
        QVERIFY(std::abs(intervals.jitterSigmaS - 0.0015 / std::sqrt(8000)) < 1e-6);
        QVERIFY(std::abs(toSeconds(intervals.usual) - 1.0 / 30) < 4 * intervals.usualSigmaS);
        QVERIFY(std::abs(intervals.usualSigmaS - 0.0015 / std::sqrt(4000)) < 5e-6);
        QVERIFY(intervals.bins.size() > 10 && int(intervals.bins.size()) <= mostIntervalBins);
        QVERIFY(intervals.bins.back().to > intervals.longest);
        QCOMPARE(countOf(intervals), 4000);
    }
    void twoFramesOfOneTime()
    {
        std::vector<Nanoseconds> times = evenTimes(20, 25);
        times[10] = times[9];
        const FrameIntervals intervals = frameIntervals(times);
        QCOMPARE(intervals.repeated, 1);
        QCOMPARE(intervals.gaps, 1);
        QCOMPARE(intervals.shortest, Nanoseconds(0));
        QCOMPARE(countOf(intervals), 19);
    }
    void tooFew()
    {
        QCOMPARE(frameIntervals({}).count, 0);
        QVERIFY(frameIntervals({0ns}).bins.empty());
        const FrameIntervals one = frameIntervals({0ns, 5s});
        QCOMPARE(one.count, 1);
        QCOMPARE(one.usual, Nanoseconds(5s));
        QCOMPARE(countOf(one), 1);
        QCOMPARE(countOf(frameIntervals({0ns, 0ns, 0ns})), 2); // no time passes
        // going backwards, as another program may have stored it
        QCOMPARE(countOf(frameIntervals({0ns, 40ms, 20ms, 60ms})), 3);
        // an hour's pause among milliseconds
        QCOMPARE(countOf(frameIntervals({0ns, 1ms, 2ms, 3ms, 3600s})), 4);
    }
};

ODOGRAPH_TEST(TestFrameIntervals, QCoreApplication)
#include "tst_frame_intervals.moc"
