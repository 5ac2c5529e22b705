// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/quantity_curve.h"
#include "core/trajectory/internal/track_profile.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>
#include <random>

using namespace odo;

namespace {

ProfilePoint point(Eigen::Vector2d velocity, Eigen::Vector2d acceleration, double sigmaSpeed = 0.001)
{
    ProfilePoint made;
    made.position.setZero();
    made.velocity = velocity;
    made.acceleration = acceleration;
    made.speedMps = velocity.norm();
    made.accelMps2 = acceleration.norm();
    made.sigmaSpeedMps = sigmaSpeed;
    made.valid = true;
    return made;
}

/// A point every thirtieth of a second.
Profile profileOf(std::vector<ProfilePoint> points)
{
    Profile profile;
    profile.points = std::move(points);
    for (std::size_t i = 0; i < profile.points.size(); ++i)
        profile.samples.emplace_back().time = fromSeconds(static_cast<double>(i) / 30);
    return profile;
}

/// Anticlockwise on a circle: turn rate w, speed w·r.
ProfilePoint onCircle(double radius, double w, double t)
{
    return point(radius * w * Eigen::Vector2d(-std::sin(w * t), std::cos(w * t)),
                 -radius * w * w * Eigen::Vector2d(std::cos(w * t), std::sin(w * t)));
}

} // namespace

class TestHeading : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aCircleTurnsEvenly()
    {
        for (const double w : {1.3, -0.4}) {
            for (double t = 0; t < 8; t += 0.37) {
                const auto course = courseOf(onCircle(0.7, w, t));
                QVERIFY(course.has_value());
                QVERIFY(std::abs(course->turnRateRadps - w) < 1e-12);
                QVERIFY(std::abs(course->sigmaHeadingRad - 0.001 / (0.7 * std::abs(w))) < 1e-12);
            }
        }
        // A straight run that speeds up does not turn.
        QCOMPARE(courseOf(point({0.5, 0}, {2, 0}))->turnRateRadps, 0.0);
    }

    void headingsGoOnPastAWholeTurn()
    {
        // Three turns to the left, in steps of 60°, from east.
        std::vector<ProfilePoint> points;
        for (int i = 0; i <= 18; ++i) {
            const double angle = i * std::numbers::pi / 3;
            points.push_back(point({std::cos(angle), std::sin(angle)}, {0, 0}));
        }
        const auto headings = headingsOf(profileOf(points));
        for (std::size_t i = 0; i < points.size(); ++i)
            QVERIFY(std::abs(headings[i]->radians - static_cast<double>(i) * std::numbers::pi / 3) < 1e-9);
    }

    void theLastHeadingIsKeptWhileItStands()
    {
        const ProfilePoint resting = point({0.0005, -0.002}, {0, 0});
        ProfilePoint unknown = resting;
        unknown.valid = false;
        QVERIFY(!courseOf(resting));
        QVERIFY(!courseOf(unknown));
        const auto headings = headingsOf(
            profileOf({resting, point({0, 1}, {0, 0}), resting, unknown, point({-1, -0.01}, {0, 0})}));
        QVERIFY(std::abs(headings[0]->radians - std::numbers::pi / 2) < 1e-12);
        QVERIFY(!headings[0]->sigmaRad.has_value());
        QVERIFY(headings[1]->sigmaRad.has_value());
        QVERIFY(std::abs(headings[2]->radians - std::numbers::pi / 2) < 1e-12);
        QVERIFY(!headings[2]->sigmaRad.has_value());
        QVERIFY(!headings[3].has_value());
        // 180.6°, not −179.4°
        QVERIFY(headings[4]->radians > std::numbers::pi);
        for (const auto &heading : headingsOf(profileOf({resting, resting, unknown})))
            QVERIFY(!heading.has_value());
        QVERIFY(headingsOf(Profile()).empty());
    }

    /// Along a line in the direction 0.5 rad: forwards, back, forwards; each part takes a second, or more.
    static Profile shuttle(const std::vector<double> &largestMps, double pauseS)
    {
        std::vector<ProfilePoint> points;
        const Eigen::Vector2d ahead(std::cos(0.5), std::sin(0.5));
        for (const double most : largestMps) {
            for (int i = 0; i < 30; ++i)
                points.push_back(point(most * std::sin(i / 30.0 * std::numbers::pi) * ahead, {0, 0}));
            points.resize(points.size() + std::size_t(std::lround(30 * pauseS)), point({0, 0}, {0, 0}));
        }
        return profileOf(std::move(points));
    }
    static double worstAway(const Profile &profile, double heading)
    {
        double worst = 0;
        for (const auto &one : headingsOf(profile)) {
            if (one->isOfBody || std::abs(one->radians - heading) > worst)
                worst = one->isOfBody ? HUGE_VAL : std::abs(one->radians - heading);
        }
        return worst;
    }

    void aReversalDoesNotTurnIt()
    {
        QVERIFY(worstAway(shuttle({0.5, -0.4, 0.6}, 0.2), 0.5) < 1e-9);
        // As long back as ahead.
        QVERIFY(worstAway(shuttle({0.5, -0.5}, 0), 0.5) < 1e-9);
        // First a little back, then far ahead.
        QVERIFY(worstAway(shuttle({-0.1, 0.6}, 0), 0.5) < 1e-9);
        // After a long stop it may have turned on the spot.
        const auto headings = headingsOf(shuttle({0.5, -0.5}, 1.5));
        QVERIFY(std::abs(headings[15]->radians - 0.5) < 1e-9);
        QVERIFY(std::abs(std::abs(headings[90]->radians - 0.5) - std::numbers::pi) < 1e-9);
        QVERIFY(!headings[50]->sigmaRad && headings[90]->sigmaRad);
    }
    void aBodyIsKnownOnTheSpot()
    {
        Profile profile = shuttle({0.5, -0.5}, 0.5);
        for (std::size_t i = 30; i < 45; ++i) // stands, and turns by 1.5 rad
            profile.points[i].body = BodyHeading{0.5 + 0.1 * double(i - 30), 0.02, 3, 0.1};
        const auto headings = headingsOf(profile);
        QVERIFY(headings[40]->isOfBody && headings[40]->radians == 1.5);
        QCOMPARE(*headings[40]->sigmaRad, 0.02);
        QVERIFY(!headings[60]->isOfBody);
        QCOMPARE(headingSource(*headings[40]), std::string_view("body"));
        QCOMPARE(headingSource(*headings[60]), std::string_view("motion"));
        QCOMPARE(turnRateOf(profile.points[40])->value, 3.0);
        // How it turns is known, but not where its front is.
        for (std::size_t i = 30; i < 45; ++i)
            profile.points[i].body->sigmaRad += unknownFrontSigmaRad;
        QVERIFY(!headingsOf(profile)[40]->isOfBody);
        QVERIFY(std::abs(headingsOf(profile)[40]->radians - 0.5) < 1e-9);
        QCOMPARE(turnRateOf(profile.points[40])->value, 3.0);
        // Of a stretch that the body says is driven backwards first.
        for (ProfilePoint &one : profile.points)
            one.body.reset();
        for (std::size_t i = 5; i < 25; ++i)
            profile.points[i].body = BodyHeading{0.5 - std::numbers::pi, 0.02, 0, 0.1};
        QVERIFY(std::abs(std::abs(headingsOf(profile)[60]->radians - 0.5) - std::numbers::pi) < 1e-9);
    }

    void sigmasAgreeWithMonteCarlo()
    {
        const double sigmaV = 0.01, sigmaA = 0.15;
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0, 1);
        for (const auto &[v, a] : {std::pair<Eigen::Vector2d, Eigen::Vector2d>{{0.6, 0.2}, {-0.5, 1.2}},
                                   {{-0.3, 0.1}, {0.9, 0}}}) {
            MotionEstimate estimate;
            estimate.mean << 0, 0, v, a;
            estimate.covariance.diagonal() << 0, 0, sigmaV * sigmaV, sigmaV * sigmaV, sigmaA * sigmaA,
                sigmaA * sigmaA;
            const auto stated = courseOf(makePoint(estimate, Eigen::Matrix2d::Zero()));
            double heading = 0, turnRate = 0;
            constexpr int draws = 5000;
            for (int i = 0; i < draws; ++i) {
                MotionEstimate drawn = estimate;
                for (int k = 2; k < 6; ++k)
                    drawn.mean[k] += std::sqrt(estimate.covariance(k, k)) * noise(random);
                const auto course = courseOf(makePoint(drawn, Eigen::Matrix2d::Zero()));
                heading += std::pow(
                    std::remainder(course->headingRad - stated->headingRad, 2 * std::numbers::pi), 2);
                turnRate += std::pow(course->turnRateRadps - stated->turnRateRadps, 2);
            }
            QVERIFY(std::abs(stated->sigmaHeadingRad / std::sqrt(heading / draws) - 1) < 0.1);
            QVERIFY(std::abs(stated->sigmaTurnRateRadps / std::sqrt(turnRate / draws) - 1) < 0.1);
        }
    }
};

ODOGRAPH_TEST(TestHeading, QCoreApplication)
#include "tst_heading.moc"
