// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/task_metrics.h"
#include "tests/analysis/measured_track.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

/// Along X at 1 m/s from −1 m to 3 m, 50 frames a second.
MeasuredTrack drive(double ownM = 0.001, double commonM = 0)
{
    MeasuredTrack track;
    for (int i = 0; i <= 200; ++i)
        track.add(i * 0.02, {-1 + i * 0.02, 0.5}, ownM, commonM);
    return track;
}

Metric metricOf(const std::vector<Metric> &metrics, const std::string &name)
{
    const auto found = std::ranges::find(metrics, name, &Metric::name);
    return found == metrics.end() ? Metric{} : *found;
}

double seconds(Nanoseconds time)
{
    return toSeconds(time);
}

} // namespace

class TestZones : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void distancesAreThoseOfTheOutline()
    {
        // An L, so that not all corners turn the same way.
        const Zone zone{"L", ZoneRule::StayInside, {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
        QVERIFY(checkZone(zone));
        QCOMPARE(depthWithin(zone, {0.5, 0.25}), 0.25);
        QCOMPARE(depthWithin(zone, {0.75, 0.75}), std::sqrt(2) / 4); // to the corner that turns inwards
        QCOMPARE(depthWithin(zone, {1.5, 1.5}), -0.5);
        QCOMPARE(depthWithin(zone, {3, -1}), -std::sqrt(2));
        Zone other = zone;
        std::ranges::reverse(other.corners); // the other way round is the same zone
        QCOMPARE(depthWithin(other, {0.5, 0.25}), 0.25);
        QCOMPARE(depthWithin(other, {1.5, 1.5}), -0.5);
    }

    void outlinesThatAreNoneAreRefused_data()
    {
        QTest::addColumn<QList<double>>("numbers");
        QTest::addColumn<QString>("why");
        QTest::newRow("line") << QList<double>{0, 0, 1, 0} << "it has fewer than three corners";
        QTest::newRow("bow") << QList<double>{0, 0, 1, 1, 1, 0, 0, 1} << "its outline crosses itself";
        QTest::newRow("back on itself") << QList<double>{0, 0, 1, 0, 2, 0} << "its outline crosses itself";
        QTest::newRow("needle") << QList<double>{0, 0, 1, 0, 1, 1, 1, -1} << "its outline crosses itself";
        QTest::newRow("touching") << QList<double>{0, 0, 2, 0, 2, 2, 1, 0, 0, 2}
                                  << "its outline crosses itself";
        QTest::newRow("corner twice")
            << QList<double>{0, 0, 1, 0, 1, 0, 1, 1} << "two corners are less than 1 mm apart";
        QTest::newRow("nowhere") << QList<double>{0, 0, 1, 0, 1, qQNaN()}
                                 << "its corners are not all on a floor of 1 km";
        QTest::newRow("square") << QList<double>{0, 0, 1, 0, 1, 1, 0, 1} << "";
        QTest::newRow("with a corner on a straight edge") << QList<double>{0, 0, 1, 0, 2, 0, 2, 1} << "";
    }
    void outlinesThatAreNoneAreRefused()
    {
        QFETCH(QList<double>, numbers);
        QFETCH(QString, why);
        Zone zone{"Field", ZoneRule::StayInside, {}};
        for (qsizetype i = 0; i < numbers.size(); i += 2)
            zone.corners.emplace_back(numbers[i], numbers[i + 1]);
        const auto valid = checkZone(zone);
        QCOMPARE(valid ? QString() : QString::fromStdString(valid.error().why.english()), why);
    }

    void tooManyAreRefused()
    {
        Zone zone{"Round", ZoneRule::StayInside, {}};
        for (int i = 0; i < 101; ++i)
            zone.corners.emplace_back(std::cos(i * 0.06), std::sin(i * 0.06));
        QCOMPARE(checkZone(zone).error().message(),
                 std::string("zone 'Round': it has more than 100 corners; draw it with fewer corners"));
        Task task;
        for (int i = 0; i < 31; ++i)
            task.zones.push_back(rectangularZone(std::to_string(i), ZoneRule::StayInside, {0, 0}, {1, 1}));
        QCOMPARE(checkTask(task).error().why.english(), std::string("the task already has 30 zones"));
    }

    void aRunBreaksARuleWhereItCrossesTheEdge()
    {
        const MeasuredTrack track = drive();
        const std::vector<Zone> zones{
            rectangularZone("Field", ZoneRule::StayInside, {-2, 0}, {2.505, 1}),
            rectangularZone("Pond", ZoneRule::StayOutside, {0.5, 0.2}, {1.255, 0.6})};
        const auto breaches = findZoneBreaches(zones, track.samples, track.points);
        QCOMPARE(breaches.size(), std::size_t(2));
        QCOMPARE(breaches[0].zone, std::string("Pond"));
        // at x = 0.5 m, a frame; the moments are nanoseconds
        QVERIFY(std::abs(seconds(breaches[0].from) - 1.5) < 1e-6);
        QVERIFY(std::abs(seconds(breaches[0].to) - 2.255) < 1e-6); // between two frames
        QVERIFY(std::abs(breaches[0].depthM - 0.1) < 1e-9);        // to the nearer long side
        QCOMPARE(breaches[1].zone, std::string("Field"));
        QVERIFY(std::abs(seconds(breaches[1].from) - 3.505) < 1e-6);
        QVERIFY(std::abs(seconds(breaches[1].to) - 4) < 1e-6); // where the track ends
        QVERIFY(std::abs(breaches[1].depthM - 0.495) < 1e-9);
        const auto metrics = measureZones(zones, track.samples, track.points);
        QCOMPARE(metricOf(metrics, "zone_breaches").value, 2.0);
        QVERIFY(std::abs(metricOf(metrics, "zone_time").value - 1.25) < 1e-6);
        QVERIFY(std::abs(metricOf(metrics, "zone_depth").value - 495) < 1e-6);
        // Three edges are crossed at 1 m/s with 1 mm, each by itself: √3 ms.
        QVERIFY(std::abs(*metricOf(metrics, "zone_time").sigma - 0.001 * std::sqrt(3)) < 1e-6);
        QVERIFY(std::abs(*metricOf(metrics, "zone_depth").sigma - 1) < 1e-6);
    }

    void theCalibrationsErrorLastsForTheRun()
    {
        const MeasuredTrack track = drive(0, 0.01);
        const std::vector<Zone> zones{rectangularZone("Pond", ZoneRule::StayOutside, {0.5, 0}, {1.5, 1})};
        // Edges that lie 10 mm further out at both ends: 20 ms at 1 m/s.
        QVERIFY(std::abs(*metricOf(measureZones(zones, track.samples, track.points), "zone_time").sigma -
                         0.02) < 1e-6);
    }

    void whatIsInDoubtIsNoBreach()
    {
        const MeasuredTrack track = drive(0.01);
        // 20 mm over the edge, with σ of 10 mm: two σ.
        std::vector<Zone> zones{rectangularZone("Field", ZoneRule::StayInside, {-2, 0}, {4, 0.48})};
        QVERIFY(findZoneBreaches(zones, track.samples, track.points).empty());
        QCOMPARE(metricOf(measureZones(zones, track.samples, track.points), "zone_time").value, 0.0);
        zones = {rectangularZone("Field", ZoneRule::StayInside, {-2, 0}, {4, 0.439})}; // 6.1 σ
        QCOMPARE(findZoneBreaches(zones, track.samples, track.points).size(), std::size_t(1));
    }

    void nothingIsJudgedInAGap()
    {
        MeasuredTrack track = drive();
        for (std::size_t i = 80; i < 120; ++i) // 0.6 m to 1.4 m
            track.points[i].valid = false;
        const std::vector<Zone> pond{rectangularZone("Pond", ZoneRule::StayOutside, {0.5, 0}, {1.5, 1})};
        const auto breaches = findZoneBreaches(pond, track.samples, track.points);
        QCOMPARE(breaches.size(), std::size_t(2));
        QVERIFY(std::abs(seconds(breaches[0].to) - 1.58) < 1e-6);
        QVERIFY(std::abs(seconds(breaches[1].from) - 2.4) < 1e-6);
        for (ProfilePoint &point : track.points)
            point.valid = false;
        QVERIFY(findZoneBreaches(pond, track.samples, track.points).empty());
        QCOMPARE(metricOf(measureZones(pond, track.samples, track.points), "zone_time").value, 0.0);
        QVERIFY(measureZones({}, track.samples, track.points).empty());
    }

    /// σ of the time against the scatter over runs of known truth: not smaller than it, and not three times
    /// as large.
    void sigmaOfTheTimeIsWhatItScattersBy()
    {
        std::mt19937 random(11);
        std::normal_distribution<double> noise(0, 0.004);
        const std::vector<Zone> pond{rectangularZone("Pond", ZoneRule::StayOutside, {0.5, 0}, {1.5, 1})};
        double sum = 0, squares = 0, stated = 0;
        constexpr int runs = 400;
        for (int run = 0; run < runs; ++run) {
            MeasuredTrack track;
            // As a smoother leaves it: errors that go together over ten frames.
            std::vector<double> errors(22);
            for (double &error : errors)
                error = noise(random);
            for (int i = 0; i <= 200; ++i) {
                const double part = (i % 10) / 10.0,
                             error = (1 - part) * errors[i / 10] + part * errors[i / 10 + 1];
                track.add(i * 0.02, {-1 + i * 0.02 + error, 0.5}, 0.004, 0);
            }
            const auto metrics = measureZones(pond, track.samples, track.points);
            const Metric time = metricOf(metrics, "zone_time");
            QCOMPARE(metricOf(metrics, "zone_breaches").value, 1.0);
            sum += time.value;
            squares += time.value * time.value;
            stated += *time.sigma / runs;
        }
        const double scatter = std::sqrt(squares / runs - sum / runs * sum / runs);
        // Between two knots the error is smaller than at them (√⅔ on average), and 400 runs give it to 4 %.
        QVERIFY2(scatter > 0.65 * stated && scatter < 1.1 * stated,
                 qPrintable(QStringLiteral("%1 of %2").arg(scatter).arg(stated)));
    }

    void aTaskMeasuresItsZones()
    {
        const MeasuredTrack track = drive();
        Task task;
        QCOMPARE(metricOf(measureTask(task, track.samples, track.points).metrics, "zone_breaches").name,
                 std::string());
        task.zones = {rectangularZone("Pond", ZoneRule::StayOutside, {0.5, 0}, {1.5, 1})};
        QCOMPARE(metricOf(measureTask(task, track.samples, track.points).metrics, "zone_breaches").value,
                 1.0);
    }
};

ODOGRAPH_TEST(TestZones, QCoreApplication)
#include "tst_zones.moc"
