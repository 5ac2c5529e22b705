// SPDX-License-Identifier: GPL-3.0-or-later
// Time in a zone, entries and the latency to the first: against closed forms and many noisy runs.
#include "core/analysis/task_metrics.h"
#include "core/analysis/zone_visits.h"
#include "tests/analysis/measured_track.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

ZoneVisits visitsOf(const MeasuredTrack &track, const Zone &zone)
{
    return findZoneVisits({zone}, track.samples, track.points).front();
}

const Zone zone{"Field", ZoneRule::StayOutside, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// Along X at 1 m/s from −1 m to 3 m, 50 frames a second.
MeasuredTrack drive(double commonM = 0, double fromS = 0)
{
    MeasuredTrack track;
    for (int i = int(fromS * 50); i <= 200; ++i)
        track.add(i * 0.02, {-1 + i * 0.02 + 0.005, 0.5}, 0.001, commonM);
    return track;
}

/// To and fro across the field's left edge, x = −0.5 cos(2t): inside in the middle halves of each period.
double swingAt(double timeS)
{
    return -0.5 * std::cos(2 * timeS);
}

} // namespace

class TestZoneVisits : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void oneCrossing()
    {
        const ZoneVisits visits = visitsOf(drive(), zone);
        QCOMPARE(visits.zone, std::string("Field"));
        QCOMPARE(visits.entries, 1);
        QVERIFY(!visits.beginsInside && !visits.isAtLeast);
        QVERIFY(std::abs(visits.insideS.value - 1) < 1e-6);
        QVERIFY(std::abs(visits.latencyS->value - 0.995) < 1e-6); // at x = 0
        QCOMPARE(visits.visits.size(), std::size_t(1));
        // 1 mm at 1 m/s: a millisecond at each end
        QVERIFY(std::abs(visits.latencyS->sigma - 0.001) < 2e-5);
        QVERIFY(std::abs(visits.insideS.sigma - 0.001 * std::sqrt(2)) < 5e-5);
    }
    void theCalibrationMovesTheEdge()
    {
        const ZoneVisits visits = visitsOf(drive(0.008), zone);
        QVERIFY(std::abs(visits.latencyS->sigma - std::hypot(0.001, 0.008)) < 1e-4);
        QVERIFY(std::abs(visits.insideS.sigma - std::hypot(0.001 * std::sqrt(2), 0.016)) < 2e-4);
    }
    /// The rule is of no account; outside of a zone to stay in is what its breaches count.
    void theRuleDoesNotMatter()
    {
        Zone stay = zone;
        stay.rule = ZoneRule::StayInside;
        const MeasuredTrack track = drive();
        const ZoneVisits visits = visitsOf(track, stay);
        QVERIFY(std::abs(visits.insideS.value - 1) < 1e-6);
        const auto breaches = findZoneBreaches({stay}, track.samples, track.points);
        double outside = 0;
        for (const ZoneBreach &breach : breaches)
            outside += toSeconds(breach.to - breach.from);
        QVERIFY(std::abs(outside + visits.insideS.value - 4) < 1e-6); // all of the run
    }
    void aRunThatBeginsInsideHasNotEntered()
    {
        const ZoneVisits visits = visitsOf(drive(0, 1.5), zone);
        QVERIFY(visits.beginsInside);
        QCOMPARE(visits.entries, 0);
        QCOMPARE(visits.latencyS->value, 0.0);
        QCOMPARE(visits.latencyS->sigma, 0.0);
        QVERIFY(std::abs(visits.insideS.value - 0.495) < 1e-6);
    }
    void neverInside()
    {
        Zone far = zone;
        for (Vector2d &corner : far.corners)
            corner.y() += 5;
        const ZoneVisits visits = visitsOf(drive(), far);
        QVERIFY(!visits.latencyS && visits.visits.empty() && visits.entries == 0);
        QCOMPARE(visits.insideS.value, 0.0);
        QVERIFY(findZoneVisits({}, {}, {}).empty());
        QVERIFY(!findZoneVisits({zone}, {}, {}).front().latencyS);
    }
    void aGapEndsAVisit()
    {
        MeasuredTrack track;
        for (int i = 0; i <= 200; ++i)
            track.add(i * 0.02, {-1 + i * 0.02 + 0.005, 0.5}, 0.001, 0, i < 60 || i > 80);
        const ZoneVisits visits = visitsOf(track, zone);
        QVERIFY(visits.isAtLeast);
        QCOMPARE(visits.visits.size(), std::size_t(2));
        QCOMPARE(visits.entries, 1); // it was inside when it was seen again
    }
    /// 300 noisy runs with three entries each: the stated σ hold, and noise makes no entry.
    void statedSigmasHold()
    {
        std::mt19937 random(7);
        std::normal_distribution<double> noise(0, 0.002);
        const double first = M_PI / 4, inside = 3 * M_PI / 2; // of each period of π half
        int latencies = 0, times = 0;
        constexpr int runs = 300;
        for (int run = 0; run < runs; ++run) {
            MeasuredTrack track;
            for (int i = 0; i <= 471; ++i) // three periods
                track.add(i * 0.02, {swingAt(i * 0.02) + noise(random), 0.5}, 0.002);
            const ZoneVisits visits = visitsOf(track, zone);
            QCOMPARE(visits.entries, 3);
            latencies += std::abs(visits.latencyS->value - first) < 1.96 * visits.latencyS->sigma;
            times += std::abs(visits.insideS.value - inside) < 1.96 * visits.insideS.sigma;
        }
        qInfo("inside 95 %%: latency %.3f, time %.3f", double(latencies) / runs, double(times) / runs);
        // 95 % of 300 are 285 ± 3.8; the crossing is interpolated between two frames, which averages
        QVERIFY(latencies >= 273 && times >= 273);
    }
};

ODOGRAPH_TEST(TestZoneVisits, QCoreApplication)
#include "tst_zone_visits.moc"
