// SPDX-License-Identifier: GPL-3.0-or-later
#include "synthetic_trial.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

const Metric &metric(const Profile &profile, const std::string &name)
{
    return *std::find_if(profile.metrics.begin(), profile.metrics.end(),
                         [&](const Metric &one) { return one.name == name; });
}

const RobotShape told{0.06, 0.26, 0.19};

} // namespace

class TestAnalyser : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void accuracyOfAFigureEight()
    {
        std::mt19937 random(1);
        const Course course = figureEight(1.2, 0.8, 6.2); // up to 2.0 m/s, 6.6 m/s²
        const auto a = film("A", cameraA(), course, {}, random);
        const auto b = film("B", cameraB(), course, {}, random);
        const auto profile = analyse({a, b}, told, {});
        QVERIFY2(profile.has_value(), profile ? "" : profile.error().message().c_str());
        const Errors errors = errorsOf(*profile, course);
        qInfo("position %.2f mm, velocity %.1f mm/s, acceleration %.0f mm/s²", errors.positionM * 1e3,
              errors.velocityMps * 1e3, errors.accelMps2 * 1e3);
        QCOMPARE(errors.points, 300);
        QVERIFY(errors.positionM < 0.003);
        QVERIFY(errors.velocityMps < 0.020);
        QVERIFY(errors.accelMps2 < 0.4);
        QCOMPARE(profile->spikes.size(), std::size_t(0));
        const Metric &fastest = metric(*profile, "max_speed");
        QVERIFY2(std::abs(fastest.value - course(0).velocity.norm()) < 3 * *fastest.sigma + 0.01,
                 qPrintable(QString::number(fastest.value)));
    }

    void errorsSayWhatToDo()
    {
        std::mt19937 random(2);
        auto a = film("A", cameraA(), figureEight(1, 1, 8), {}, random);
        auto unregistered = a;
        unregistered.floorView.reset();
        const auto first = analyse({unregistered}, told, {});
        QVERIFY(!first);
        QCOMPARE(first.error().code, ErrorCode::Undetermined);
        QCOMPARE(
            first.error().message(),
            std::string("the robot's path cannot be measured: camera A is not registered to the floor; run "
                        "odograph register for at least one of them"));
        for (Observation &observation : a.observations)
            observation.found = false;
        const auto lost = analyse({a}, told, {});
        QVERIFY(!lost);
        QVERIFY(lost.error().message().find("not found in any picture of A; check that the robot's colour") !=
                std::string::npos);
        QVERIFY(!analyse({}, told, {}));
    }
};

QTEST_GUILESS_MAIN(TestAnalyser)
#include "tst_analyser.moc"
