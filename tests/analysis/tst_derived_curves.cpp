// SPDX-License-Identifier: GPL-3.0-or-later
// Curves derived from a profile: against closed forms, and their σ against many simulated runs.
#include "core/analysis/curve_fit.h"
#include "core/analysis/metrics.h"
#include "core/analysis/quantity_curve.h"
#include "core/analysis/range_statistics.h"
#include "core/trajectory/internal/track_profile.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <functional>
#include <random>

using namespace odo;

namespace {

/// Position, velocity and acceleration at a time.
struct Motion
{
    Eigen::Vector2d position, velocity, acceleration;
};
using Course = std::function<Motion(double timeS)>;

constexpr double rate = 50;

/// Exact points with the given σ of speed and acceleration; positions are known to 1 mm.
Profile exactly(const Course &course, double durationS, double sigmaSpeed, double sigmaAccel)
{
    Profile profile;
    for (int i = 0; i <= int(durationS * rate); ++i) {
        const Motion motion = course(i / rate);
        Sample sample;
        sample.frame = i;
        sample.time = fromSeconds(i / rate);
        sample.position = motion.position;
        sample.covariance = Eigen::Matrix2d::Identity() * 1e-6;
        profile.samples.push_back(sample);
        ProfilePoint point{motion.position, motion.velocity, motion.acceleration, 1e-3, 1e-3};
        point.speedMps = motion.velocity.norm();
        point.sigmaSpeedMps = sigmaSpeed;
        point.accelMps2 = motion.acceleration.norm();
        point.sigmaAccelMps2 = sigmaAccel;
        point.valid = true;
        profile.points.push_back(point);
    }
    return profile;
}

/// 0.8 m/s round a circle of 0.5 m, anticlockwise: 1.28 m/s² to the left, and no other acceleration.
Motion circle(double t)
{
    const double angle = 1.6 * t;
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle)), along(-out.y(), out.x());
    return {0.5 * out, 0.8 * along, -1.28 * out};
}

/// Straight ahead with a jerk of 0.6 m/s³ and 1 m/s at the beginning.
Motion jerking(double t)
{
    return {{t + 0.1 * t * t * t, 2}, {1 + 0.3 * t * t, 0}, {0.6 * t, 0}};
}

constexpr double jerkDensity = 0.05; ///< m²/s⁵

/// A motion by a white jerk, from 0.6 m/s on.
class DrawnRun
{
public:
    explicit DrawnRun(std::mt19937 &random)
    {
        std::normal_distribution<double> step(0, std::sqrt(jerkDensity * stepS));
        Motion motion{{0, 0}, {0.6, 0}, {0, 0}};
        double distance = 0;
        for (int i = 0; i <= int(5 / stepS) + 1; ++i) {
            m_motions.push_back(motion);
            m_distances.push_back(distance);
            distance += motion.velocity.norm() * stepS;
            motion.position += motion.velocity * stepS;
            motion.velocity += motion.acceleration * stepS;
            motion.acceleration += Eigen::Vector2d(step(random), step(random));
        }
    }
    const Motion &at(double timeS) const { return m_motions[std::size_t(std::lround(timeS / stepS))]; }
    double distance(double timeS) const { return m_distances[std::size_t(std::lround(timeS / stepS))]; }

private:
    static constexpr double stepS = 0.0005;
    std::vector<Motion> m_motions;
    std::vector<double> m_distances;
};

/// The smoothed measurements of a course with noise of 2 mm.
Profile smoothed(const Course &course, double durationS, std::mt19937 &random)
{
    constexpr double sigma = 0.002;
    std::normal_distribution<double> noise(0, sigma);
    Profile profile;
    for (int i = 0; i <= int(durationS * rate); ++i) {
        Sample sample;
        sample.frame = i;
        sample.time = fromSeconds(i / rate);
        sample.position = course(i / rate).position + Eigen::Vector2d(noise(random), noise(random));
        sample.covariance = Eigen::Matrix2d::Identity() * sigma * sigma;
        profile.samples.push_back(sample);
    }
    profile.points = makePoints(profile.samples, {}, {}, {jerkDensity, 1});
    return profile;
}

} // namespace

class TestDerivedCurves : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aCircleAcceleratesToTheLeft()
    {
        const Profile profile = exactly(circle, 4, 0.01, 0.05);
        const std::size_t i = 100;
        const auto at = [&](Quantity quantity) { return *quantityValues(profile, quantity)[i]; };
        QVERIFY(std::abs(at(Quantity::LateralAcceleration).value - 1.28) < 1e-9);
        QVERIFY(std::abs(at(Quantity::Acceleration).value) < 1e-9);
        // Nothing along the path: an error of the direction changes nothing of first order.
        QVERIFY(std::abs(at(Quantity::LateralAcceleration).sigma - 0.05) < 1e-9);
        QCOMPARE(at(Quantity::VelocityX).value, circle(2).velocity.x());
        QCOMPARE(at(Quantity::VelocityY).value, circle(2).velocity.y());
        QCOMPARE(at(Quantity::VelocityX).sigma, 0.01);
        const double chord = 2 * 0.5 * std::sin(1.6); // of 3.2 rad
        QVERIFY(std::abs(at(Quantity::Displacement).value - std::abs(chord)) < 1e-9);
        // both ends, 1 mm each; the calibration has no part here
        QVERIFY(std::abs(at(Quantity::Displacement).sigma - 1e-3 * std::sqrt(2)) < 1e-6);
        QCOMPARE(quantityValues(profile, Quantity::Displacement)[0]->sigma, 0.0);
        // clockwise is to the right
        const Profile back = exactly([](double t) { return circle(-t); }, 4, 0.01, 0.05);
        Profile clockwise = back;
        for (ProfilePoint &point : clockwise.points)
            point.velocity = -point.velocity;
        QVERIFY(quantityValues(clockwise, Quantity::LateralAcceleration)[i]->value < -1.27);
    }
    void aRobotAtRestHasNoSide()
    {
        const auto rest = [](double) { return Motion{{1, 1}, {0.001, 0}, {0, 0.02}}; };
        const Profile profile = exactly(rest, 1, 0.01, 0.05);
        QVERIFY(!quantityValues(profile, Quantity::LateralAcceleration)[20]);
        QVERIFY(quantityValues(profile, Quantity::Jerk)[20]);
        QCOMPARE(quantityValues(profile, Quantity::Distance)[50]->value, 0.0);
    }
    void theJerkIsTheSlopeOfTheAcceleration()
    {
        const Profile profile = exactly(jerking, 2, 0.05, 0.3);
        const auto jerk = quantityValues(profile, Quantity::Jerk);
        for (std::size_t i = 5; i <= 95; ++i)
            QVERIFY(jerk[i] && std::abs(jerk[i]->value - 0.6) < 1e-9);
        QVERIFY(!jerk[4] && !jerk[96]); // half of the time is 5 frames
        const double together = errorCorrelation(ErrorCourse::Acceleration, errorRate(1e-3, 0.05) * 0.2);
        QVERIFY(std::abs(jerk[50]->sigma - 0.3 * std::sqrt(2 - 2 * together) / 0.2) < 1e-9);
    }
    void aGapEndsIt()
    {
        Profile profile = exactly(jerking, 2, 0.05, 0.3);
        profile.points[50].valid = false;
        const auto jerk = quantityValues(profile, Quantity::Jerk);
        for (std::size_t i = 46; i <= 54; ++i)
            QVERIFY(!jerk[i]);
        QVERIFY(jerk[44] && jerk[56]);
        QVERIFY(!quantityValues({}, Quantity::Jerk).size());
        QVERIFY(quantityValues({}, Quantity::Displacement).empty());
    }
    /// Two that drive apart at 3 m/s from 0.1 m on, at right angles to what a third does; one at other times.
    void theSeparationIsFromTheNearest()
    {
        const auto right = [](double t) { return Motion{{2 * t, 0}, {2, 0}, {0, 0}}; };
        const auto left = [](double t) { return Motion{{-0.1 - t, 0}, {-1, 0}, {0, 0}}; };
        const auto far = [](double t) { return Motion{{0, 9 - 2 * t}, {0, -2}, {0, 0}}; };
        const Profile one = exactly(right, 4, 0.01, 0.05), third = exactly(far, 4, 0.01, 0.05);
        Profile other = exactly(left, 4, 0.01, 0.05);
        for (Sample &sample : other.samples) // between the frames of the first
            sample.time += fromSeconds(0.007);
        for (std::size_t i = 0; i < other.points.size(); ++i)
            other.points[i].position.x() -= 0.007;
        const std::vector<const Profile *> others{&other, &third};
        const auto values = quantityValues(one, Quantity::Separation, others);
        QVERIFY(std::abs(values[50]->value - 3.1) < 1e-9);                 // 1 s
        QVERIFY(std::abs(values[200]->value - std::hypot(8, 1)) < 1e-9);   // 4 s: the third is nearer
        QVERIFY(std::abs(values[50]->sigma - 1e-3 * std::sqrt(2)) < 1e-6); // 1 mm each
        QVERIFY(!quantityValues(one, Quantity::Separation)[50]);           // alone
        other.points[50].valid = other.points[49].valid = false;
        const std::vector<const Profile *> gappy{&other};
        QVERIFY(!quantityValues(one, Quantity::Separation, gappy)[50]); // not measured then
        QVERIFY(quantityValues(one, Quantity::Separation, gappy)[60]);
    }
    void theDistanceEndsWithThePath()
    {
        std::mt19937 random(5);
        const Profile profile = smoothed(circle, 5, random);
        const auto distance = quantityValues(profile, Quantity::Distance);
        double before = 0;
        for (const auto &value : distance) {
            QVERIFY(value && value->value >= before && value->sigma >= 0);
            before = value->value;
        }
        const std::vector<Metric> metrics = measureRun(profile.samples, profile.points);
        for (const Metric &metric : metrics)
            if (metric.name == "path_length") {
                QVERIFY(std::abs(before - metric.value) < 0.02); // the ramp at the end is the last step's
                // of the same terms, but for what the robot does beside a motion
                QVERIFY(distance.back()->sigma < 1.2 * *metric.sigma + 1e-4);
                QVERIFY(distance.back()->sigma > 0.5 * *metric.sigma);
            }
    }
    /// Raw differences, where they mean anything.
    void measuredPointsBesideThem()
    {
        const Profile profile = exactly(circle, 4, 0.01, 0.05);
        QVERIFY(std::abs(measuredValues(profile, Quantity::VelocityX)[100]->value - circle(2).velocity.x()) <
                1e-3); // (ωΔt)²/6 of 0.8 m/s
        QVERIFY(std::abs(measuredValues(profile, Quantity::Displacement)[100]->value -
                         (circle(2).position - circle(0).position).norm()) < 1e-12);
        for (const Quantity none : {Quantity::LateralAcceleration, Quantity::Jerk, Quantity::Distance})
            QVERIFY(!measuredValues(profile, none)[100]);
    }
    void statisticsTakeThemToo()
    {
        const Profile profile = exactly(circle, 4, 0.01, 0.05);
        const TimeSpan span{fromSeconds(1), fromSeconds(3)};
        const Profile other = exactly(jerking, 4, 0.01, 0.05);
        const std::vector<const Profile *> others{&other};
        for (const Quantity quantity : allQuantities())
            QVERIFY(statisticsOf(profile, quantity, span, others));
        QVERIFY(!statisticsOf(profile, Quantity::Separation, span));
        QVERIFY(std::abs(statisticsOf(profile, Quantity::LateralAcceleration, span)->mean.value - 1.28) <
                1e-9);
        const auto fit = fitQuantity(exactly(jerking, 2, 0.05, 0.3), Quantity::VelocityX,
                                     {fromSeconds(0.2), fromSeconds(1.8)}, FitShape::Parabola);
        QVERIFY(fit && std::abs(fit->coefficients[2] - 0.3) < 1e-6);
    }
    /// Robots that move as the smoother assumes, by a white jerk: 200 runs with noise, at three times far
    /// from the ends. 95 % of 600 are expected within 1.96 σ, with a standard deviation of 0.9 % if all were
    /// independent; σ of first order is a little too small where a robot is slow.
    void statedSigmasHold_data()
    {
        QTest::addColumn<int>("quantity");
        QTest::newRow("vx") << int(Quantity::VelocityX);
        QTest::newRow("lateral") << int(Quantity::LateralAcceleration);
        QTest::newRow("jerk") << int(Quantity::Jerk);
        QTest::newRow("distance") << int(Quantity::Distance);
        QTest::newRow("displacement") << int(Quantity::Displacement);
    }
    void statedSigmasHold()
    {
        QFETCH(int, quantity);
        int inside = 0, all = 0;
        double sumSquares = 0;
        std::mt19937 random(11);
        for (int run = 0; run < 200; ++run) {
            const DrawnRun drawn(random);
            const Profile profile = smoothed([&](double t) { return drawn.at(t); }, 5, random);
            const auto values = quantityValues(profile, Quantity(quantity));
            for (const double t : {1.5, 2.5, 3.5}) {
                const auto &value = values[std::size_t(std::lround(t * rate))];
                if (!value) // it stands, and has no side
                    continue;
                QVERIFY(value->sigma > 0);
                const double error = value->value - truth(Quantity(quantity), drawn, t);
                inside += std::abs(error) <= 1.96 * value->sigma;
                sumSquares += std::pow(error / value->sigma, 2);
                ++all;
            }
        }
        const double share = double(inside) / all, rms = std::sqrt(sumSquares / all);
        qInfo("%d values, inside 95 %%: %.3f, rms of error/sigma %.2f", all, share, rms);
        QVERIFY(all > 550);
        QVERIFY(share >= 0.91);
        QVERIFY(rms > 0.8 && rms < 1.25); // nor are they stated too large
    }

private:
    static double truth(Quantity quantity, const DrawnRun &run, double t)
    {
        const Motion now = run.at(t);
        switch (quantity) {
        case Quantity::VelocityX:
            return now.velocity.x();
        case Quantity::LateralAcceleration:
            return (now.velocity.x() * now.acceleration.y() - now.velocity.y() * now.acceleration.x()) /
                   now.velocity.norm();
        case Quantity::Jerk:
            return (run.at(t + jerkSpanS / 2).acceleration - run.at(t - jerkSpanS / 2).acceleration)
                       .dot(now.velocity) /
                   now.velocity.norm() / jerkSpanS;
        case Quantity::Distance:
            return run.distance(t);
        default:
            return (now.position - run.at(0).position).norm();
        }
    }
};

ODOGRAPH_TEST(TestDerivedCurves, QCoreApplication)
#include "tst_derived_curves.moc"
