// SPDX-License-Identifier: GPL-3.0-or-later
// A run cut to a range, put together again, and the range of its motion.
#include "core/analysis/range/run_range.h"

#include "core/trajectory/imported_track.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

using namespace odo;

namespace {

constexpr double stepS = 0.04, noiseM = 0.002, speedMps = 0.5;
constexpr double startS = 2, driveS = 4, restS = 3;

/// The robot rests for 2 s, drives straight at 0.5 m/s for 4 s and rests for 3 s.
double distanceAt(double t)
{
    return speedMps * std::clamp(t - startS, 0.0, driveS);
}

/// hole: samples without a position, from one to before the other.
Profile run(double spikeM = 0, std::pair<int, int> hole = {0, 0})
{
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, noiseM);
    std::vector<ImportedPosition> track;
    for (int i = 0; i * stepS <= startS + driveS + restS; ++i) {
        const double t = i * stepS;
        ImportedPosition &position = track.emplace_back();
        position.time = fromSeconds(t);
        const Eigen::Vector2d at(distanceAt(t) + noise(random) + (i == 12 ? spikeM : 0), noise(random));
        if (i < hole.first || i >= hole.second)
            position.position = at;
    }
    const auto raw = samplesOfImported(track, noiseM);
    return analyseImported(raw, optionsForImported({}, raw)).value();
}

double metric(const Profile &profile, const char *name)
{
    const auto found = std::ranges::find(profile.metrics, std::string(name), &Metric::name);
    return found == profile.metrics.end() ? -1 : found->value;
}

bool isSame(const Profile &a, const Profile &b)
{
    const auto sameMetrics = [](const Metric &one, const Metric &other) {
        return one.name == other.name && one.value == other.value && one.sigma == other.sigma &&
               one.isAtLeast == other.isAtLeast;
    };
    return a.samples.size() == b.samples.size() && a.points.size() == b.points.size() &&
           std::ranges::equal(a.samples, b.samples, {}, &Sample::time, &Sample::time) &&
           std::ranges::equal(a.spikes, b.spikes, {}, &Spike::sampleIndex, &Spike::sampleIndex) &&
           std::ranges::equal(a.metrics, b.metrics, sameMetrics) && a.gaps == b.gaps &&
           a.measuredS == b.measuredS;
}

TimeSpan span(double from, double to)
{
    return {fromSeconds(from), fromSeconds(to)};
}

} // namespace

class TestRunRange : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void bothEndsAreIncluded()
    {
        Profile part = run();
        const std::size_t all = part.samples.size();
        const OutsideRange outside = cutToRange(part, span(3, 5));
        QCOMPARE(part.samples.size(), std::size_t(51)); // 2 s at 25/s, and one
        QCOMPARE(part.samples.front().time, fromSeconds(3));
        QCOMPARE(part.samples.back().time, fromSeconds(5));
        QCOMPARE(part.points.size(), part.samples.size());
        QCOMPARE(outside.before.samples.size(), std::size_t(75));
        QCOMPARE(outside.before.samples.size() + part.samples.size() + outside.after.samples.size(), all);
        QVERIFY(std::abs(part.measuredS - 2) < 1e-9);
    }

    /// At 0.5 m/s for 2 s: the distance is known, and neither rest is in it.
    void metricsAreOfThePart()
    {
        Profile part = run();
        QVERIFY(metric(part, "path_length") > 1.9);
        OutsideRange outside;
        changeRange(part, outside, span(3, 5), nullptr);
        QVERIFY(std::abs(metric(part, "path_length") - 1) < 0.01); // σ is some mm
        QVERIFY(std::abs(metric(part, "duration") - 2) < 1e-6);
        QVERIFY(std::abs(metric(part, "standing_time")) < 1e-6);
    }

    void aSpikeGoesWithItsSample()
    {
        Profile part = run(0.3);
        QCOMPARE(part.spikes.size(), std::size_t(1));
        QCOMPARE(part.spikes[0].sampleIndex, std::int64_t(12));
        Profile late = part;
        QVERIFY(cutToRange(late, span(3, 5)).before.spikes.size() == 1 && late.spikes.empty());
        const OutsideRange outside = cutToRange(part, span(0.4, 5));
        QCOMPARE(part.spikes.size(), std::size_t(1));
        QCOMPARE(part.spikes[0].sampleIndex, std::int64_t(2)); // 0.48 s, of samples from 0.4 s on
        QCOMPARE(wholeRun(part, outside).spikes[0].sampleIndex, std::int64_t(12));
    }

    /// From range to range and back: every number is the one it was.
    void theWholeRunComesBack()
    {
        const Profile whole = run(0.3, {120, 130});
        Profile part = whole;
        OutsideRange outside;
        changeRange(part, outside, span(1, 5), nullptr);
        QVERIFY(!isSame(part, whole));
        changeRange(part, outside, span(4, 8), nullptr);
        Profile other = whole;
        OutsideRange rest;
        changeRange(other, rest, span(4, 8), nullptr);
        QVERIFY(isSame(part, other));
        changeRange(part, outside, std::nullopt, nullptr);
        QVERIFY(isSame(part, whole));
        QVERIFY(outside.before.samples.empty() && outside.after.samples.empty());
    }

    /// A gap of 2 s makes the path at least so long; in a range without it the path is known.
    void aGapOutsideCountsNoMore()
    {
        Profile part = run(0, {60, 110});
        const auto isAtLeast = [&] {
            return std::ranges::find(part.metrics, "path_length", &Metric::name)->isAtLeast;
        };
        QCOMPARE(part.gaps.size(), std::size_t(1));
        QVERIFY(isAtLeast());
        OutsideRange outside;
        changeRange(part, outside, span(4.5, 8), nullptr);
        QVERIFY(part.gaps.empty() && !isAtLeast());
        changeRange(part, outside, std::nullopt, nullptr);
        QVERIFY(isAtLeast());
    }

    /// The samples don't show that the robot moved while no view saw it: such a bound stays.
    void otherLowerBoundsStay()
    {
        Profile part = run();
        for (Metric &one : part.metrics)
            one.isAtLeast = one.name == "path_length" || one.name == "duration";
        OutsideRange outside;
        changeRange(part, outside, span(3, 5), nullptr);
        QVERIFY(std::ranges::find(part.metrics, "duration", &Metric::name)->isAtLeast);
        QVERIFY(std::ranges::find(part.metrics, "path_length", &Metric::name)->isAtLeast);
    }

    void aRangeWithoutSamples()
    {
        Profile part = run();
        OutsideRange outside;
        changeRange(part, outside, span(100, 200), nullptr);
        QVERIFY(part.samples.empty() && part.metrics.empty() && !hasValidPoint(part));
        changeRange(part, outside, std::nullopt, nullptr);
        QVERIFY(isSame(part, run()));
    }

    /// The drive is from 2 s to 6 s; a smoothed start is early by a few samples.
    void motionIsFromTheFirstToTheLast()
    {
        const auto motion = motionSpan(run());
        QVERIFY(motion.has_value());
        const double from = toSeconds(motion->begin), to = toSeconds(motion->end);
        QVERIFY2(from > 1.8 && from <= 2.1, qPrintable(QString::number(from)));
        QVERIFY2(to >= 5.9 && to < 6.2, qPrintable(QString::number(to)));
    }

    /// A false position half a metre away while the robot rests is no motion.
    void aSpikeIsNoMotion()
    {
        const auto motion = motionSpan(run(0.5));
        QVERIFY(motion && toSeconds(motion->begin) > 1.7);
    }

    void restIsNoMotion()
    {
        Profile part = run();
        cutToRange(part, span(0, 1.5));
        QVERIFY(!motionSpan(part));
        QVERIFY(!motionSpan(Profile()));
    }

    /// A stretch of which nothing was used does not begin the motion.
    void whatIsFlaggedIsNoMotion()
    {
        Profile part = run();
        for (std::size_t i = 0; i < part.samples.size() && part.samples[i].time < fromSeconds(7); ++i)
            part.samples[i].flags |= flagBit(SampleFlag::Lost);
        QVERIFY(!motionSpan(part));
    }
};

ODOGRAPH_TEST(TestRunRange, QCoreApplication)
#include "tst_run_range.moc"
