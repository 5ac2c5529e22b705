// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/quantity_curve.h"

#include "core/analysis/metrics.h"
#include "core/analysis/motion_stretches.h"
#include "core/trajectory/internal/track_profile.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>

using namespace odo;

namespace {

constexpr double rate = 60;

/// Round a circle of 1 m at 0.5 m/s, from a rest of half a second on: exact positions of σ = 1 mm.
Eigen::Vector2d positionAt(double timeS)
{
    const double angle = 0.5 * std::max(0.0, timeS - 0.5);
    return {std::cos(angle), std::sin(angle)};
}

Profile circle(double durationS)
{
    Profile profile;
    for (int i = 0; i <= int(durationS * rate); ++i) {
        Sample sample;
        sample.frame = i;
        sample.time = fromSeconds(i / rate);
        sample.position = positionAt(i / rate);
        sample.covariance = Eigen::Matrix2d::Identity() * 1e-6;
        profile.samples.push_back(sample);
    }
    profile.points = makePoints(profile.samples, {}, {}, {20, 1});
    return profile;
}

} // namespace

class TestQuantityCurve : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void measuredValuesAreDifferences()
    {
        const Profile profile = circle(3);
        const std::size_t i = 120; // 2 s: in the midst of the circle
        const auto at = [&](Quantity quantity) { return measuredValues(profile, quantity)[i]; };
        // A chord of the circle is shorter than the arc by (ωΔt)²/6 of it.
        QVERIFY(std::abs(at(Quantity::Speed)->value - 0.5) < 1e-4);
        QVERIFY(std::abs(at(Quantity::Acceleration)->value) < 5e-3); // all of it is across the path
        QVERIFY(std::abs(at(Quantity::Heading)->value - (0.75 + M_PI / 2)) < 1e-3);
        QCOMPARE(at(Quantity::PositionX)->value, std::cos(0.75));
        QCOMPARE(at(Quantity::PositionY)->sigma, 1e-3);
        QVERIFY(!at(Quantity::TurnRate));
    }
    void headingGoesOnOverWholeTurns()
    {
        const Profile profile = circle(20); // 9.75 rad of turning
        const auto measured = measuredValues(profile, Quantity::Heading);
        const auto smoothed = quantityValues(profile, Quantity::Heading);
        const std::size_t i = 1190;
        QVERIFY(std::abs(measured[i]->value - (0.5 * (i / rate - 0.5) + M_PI / 2)) < 1e-2);
        QVERIFY(std::abs(measured[i]->value - smoothed[i]->value) < 1e-2);
    }
    void rejectedNeighboursGiveNothing()
    {
        Profile profile = circle(3);
        profile.samples[120].flags = flagBit(SampleFlag::Jump);
        for (const std::size_t i : {119u, 120u, 121u})
            QVERIFY(!measuredValues(profile, Quantity::Speed)[i]);
        QVERIFY(measuredValues(profile, Quantity::Speed)[122]);
        QVERIFY(!measuredValues(profile, Quantity::Acceleration)[122]);
        QVERIFY(!measuredValues(profile, Quantity::PositionX)[120]);
        QVERIFY(measuredSpeed(profile, 120)); // whatever the flags are
        QVERIFY(!measuredSpeed(profile, 0));
        QVERIFY(!measuredValues(profile, Quantity::Heading)[5]); // it stands
    }
    void wayDrivenIsThePathLength()
    {
        const Profile profile = circle(5);
        const std::vector<double> distances = distanceTravelled(profile.samples, profile.points);
        QCOMPARE(distances.size(), profile.points.size());
        QVERIFY(std::is_sorted(distances.begin(), distances.end()));
        QCOMPARE(distances[10], 0.0); // it stands
        // The blur of the sudden start is some frames long.
        QVERIFY(std::abs(distances.back() - 0.5 * 4.5) < 0.02);
        QVERIFY(std::abs(distances[200] - distances[100] - 0.5 * 100 / rate) < 2e-3);
        for (const Metric &metric : measureRun(profile.samples, profile.points))
            if (metric.name == "path_length")
                QVERIFY(std::abs(metric.value - distances.back()) < 1e-9);
    }
    void nothingDrivesNoWay()
    {
        QVERIFY(distanceTravelled({}, {}).empty());
        Profile profile = circle(0.3); // it only stands
        for (const double distance : distanceTravelled(profile.samples, profile.points))
            QCOMPARE(distance, 0.0);
    }
};

ODOGRAPH_TEST(TestQuantityCurve, QCoreApplication)
#include "tst_quantity_curve.moc"
