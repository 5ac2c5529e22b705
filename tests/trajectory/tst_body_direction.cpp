// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/body_direction.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <functional>
#include <numbers>
#include <random>

using namespace odo;

namespace {

using Path = std::function<Eigen::Vector2d(double timeS)>;

std::vector<Sighting> seen(const Path &path, double firstS, double lastS, double perSecond = 30)
{
    std::vector<Sighting> sightings;
    for (double t = firstS; t <= lastS; t += 1 / perSecond) {
        Sighting sighting;
        sighting.time = fromSeconds(t);
        sighting.seen = true;
        sighting.position.pointInWorld = path(t);
        sightings.push_back(sighting);
    }
    return sightings;
}

/// At 0.5 m/s.
Path circle(double radiusM, bool isToTheLeft)
{
    return [=](double t) {
        const double angle = 0.5 / radiusM * t;
        return Eigen::Vector2d(radiusM * std::sin(angle),
                               (isToTheLeft ? 1 : -1) * radiusM * (1 - std::cos(angle)));
    };
}

} // namespace

class TestBodyDirection : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void onACircle_data()
    {
        QTest::addColumn<double>("radius");
        QTest::addColumn<bool>("isToTheLeft");
        for (const double radius : {0.5, 2.0}) {
            QTest::addRow("%g m to the left", radius) << radius << true;
            QTest::addRow("%g m to the right", radius) << radius << false;
        }
    }
    void onACircle()
    {
        QFETCH(double, radius);
        QFETCH(bool, isToTheLeft);
        const Path path = circle(radius, isToTheLeft);
        const std::vector<std::vector<Sighting>> views{seen(path, 0, 4), seen(path, 0.011, 4)};
        for (const double t : {0.5, 1.7, 3.2}) {
            const auto motion = motionAt(views, fromSeconds(t));
            QVERIFY(motion.has_value());
            const double direction = (isToTheLeft ? 1 : -1) * 0.5 / radius * t;
            // A parabola over half a second is not quite the circle: the speed comes out 0.6 % too small at
            // one turn in 6 s, the curvature 0.8 % too large.
            QVERIFY2(std::abs(std::remainder(motion->directionRad - direction, 2 * std::numbers::pi)) < 0.002,
                     qPrintable(QString::number(motion->directionRad)));
            QVERIFY2(std::abs(motion->curvature * radius - (isToTheLeft ? 1 : -1)) < 0.015,
                     qPrintable(QString::number(motion->curvature)));
        }
    }

    void onAStraightLine()
    {
        const Path path = [](double t) { return Eigen::Vector2d(1 - 0.6 * t, 0.3 - 0.8 * t); };
        const auto motion = motionAt({seen(path, 0, 2)}, fromSeconds(1));
        QVERIFY(motion.has_value());
        // times are whole nanoseconds
        QVERIFY(std::abs(motion->directionRad - std::atan2(-0.8, -0.6)) < 1e-6);
        QVERIFY2(std::abs(motion->curvature) < 1e-6, qPrintable(QString::number(motion->curvature)));
    }

    void whatHardlyMovesHasNone()
    {
        std::mt19937 random(1);
        std::normal_distribution<double> noise(0, 0.001);
        const Path standing = [&](double) {
            return Eigen::Vector2d(0.3 + noise(random), 0.2 + noise(random));
        };
        QVERIFY(!motionAt({seen(standing, 0, 2)}, fromSeconds(1)));
        const Path creeping = [](double t) { return Eigen::Vector2d(0.1 * t, 0); };
        QVERIFY(!motionAt({seen(creeping, 0, 2)}, fromSeconds(1)));
    }

    void fromTooFewPlacesThereIsNone()
    {
        const Path path = circle(0.5, true);
        QVERIFY(!motionAt({}, fromSeconds(1)));
        QVERIFY(!motionAt({seen(path, 0, 2)}, fromSeconds(5)));
        QVERIFY(!motionAt({seen(path, 0, 2, 8)}, fromSeconds(1))); // five of them
        auto unseen = seen(path, 0, 2);
        for (Sighting &sighting : unseen)
            sighting.seen = false;
        QVERIFY(!motionAt({unseen}, fromSeconds(1)));
        // A view that saw it leaves the other out.
        unseen[30].seen = true;
        unseen[30].position.pointInWorld = {9, 9};
        const auto motion = motionAt({unseen, seen(path, 0, 2)}, fromSeconds(1));
        QVERIFY(motion && std::abs(motion->directionRad - 1) < 0.002 &&
                std::abs(motion->curvature - 2) < 0.03);
    }
};

ODOGRAPH_TEST(TestBodyDirection, QCoreApplication)
#include "tst_body_direction.moc"
