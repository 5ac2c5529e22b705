// SPDX-License-Identifier: GPL-3.0-or-later
// The noise of a run in its regimes: rest, drive and impact beside one another, and an error that wobbles.
#include "core/trajectory/internal/motion_noise.h"
#include "core/trajectory/internal/spike_flags.h"
#include "core/trajectory/internal/track_profile.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double framesPerSecond = 60;

/// Slides from rest with 0.8 m/s², and from impactS on rattles about a place.
Course slide(double impactS)
{
    return [=](double t) {
        const double s = std::min(t, impactS), u = std::max(0.0, t - impactS);
        Truth truth;
        truth.position.x() = 0.4 * s * s + 0.01 * std::sin(60 * u) * std::exp(-3 * u);
        truth.velocity.x() = u > 0 ? 0 : 0.8 * s;
        truth.acceleration.x() = u > 0 ? 0 : 0.8;
        return truth;
    };
}

std::vector<Sample> measured(const Course &course, double durationS, double sigmaM, unsigned seed,
                             double wobbleM = 0)
{
    constexpr double wobbleRate = 2 * M_PI * 4; // as of a mast that rocks four times a second
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 1);
    std::vector<Sample> samples;
    Eigen::Vector2d wobble(noise(random), noise(random)), first = wobble; // two filters make ν = 3/2
    const double kept = std::exp(-wobbleRate / framesPerSecond);
    for (int i = 0; i <= durationS * framesPerSecond; ++i) {
        Sample sample;
        sample.frame = i;
        sample.time = fromSeconds(i / framesPerSecond);
        first = kept * first + std::sqrt(1 - kept * kept) * Eigen::Vector2d(noise(random), noise(random));
        wobble = kept * wobble + (1 - kept) * std::sqrt(2.0) * first;
        sample.position = course(i / framesPerSecond).position + wobbleM * wobble +
                          sigmaM * Eigen::Vector2d(noise(random), noise(random));
        sample.covariance = Eigen::Matrix2d::Identity() * sigmaM * sigmaM;
        samples.push_back(sample);
    }
    return samples;
}

/// With an error of independent steps that is forgotten within lastsS.
std::vector<Sample> drifting(const Course &course, double durationS, double sigmaM, double lastsS,
                             unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, sigmaM);
    std::vector<Sample> samples;
    Eigen::Vector2d drift(noise(random), noise(random));
    const double kept = std::exp(-1 / (lastsS * framesPerSecond));
    for (int i = 0; i <= durationS * framesPerSecond; ++i) {
        Sample &sample = samples.emplace_back();
        sample.frame = i;
        sample.time = fromSeconds(i / framesPerSecond);
        drift = kept * drift + std::sqrt(1 - kept * kept) * Eigen::Vector2d(noise(random), noise(random));
        sample.position = course(i / framesPerSecond).position + drift;
        sample.covariance = Eigen::Matrix2d::Identity() * 1e-6;
    }
    return samples;
}

std::vector<ProfilePoint> smoothed(std::vector<Sample> samples, bool mayWobble = false)
{
    MeasurementNoise measurement;
    measurement.mayWobble = mayWobble;
    const SpikeVerdict verdict = flagSpikes(samples, {}, measurement);
    return makePoints(samples, verdict.changes, {}, verdict.noise);
}

struct Spread
{
    double rms = 0, sigma = 0, within = 0; ///< share within two σ
};

/// Of a coordinate's acceleration, or of the speed, between two times.
template <class Value>
Spread errorOf(const std::vector<ProfilePoint> &points, double fromS, double toS, const Value &value)
{
    Spread error;
    double count = 0;
    for (auto i = std::size_t(fromS * framesPerSecond); i < std::size_t(toS * framesPerSecond); ++i) {
        const auto [off, sigma] = value(points[i], double(i) / framesPerSecond);
        error.rms += off * off;
        error.sigma += sigma * sigma;
        error.within += std::abs(off) <= 2 * sigma;
        ++count;
    }
    return {std::sqrt(error.rms / count), std::sqrt(error.sigma / count), error.within / count};
}

} // namespace

class TestMotionNoise : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// What comes later makes nothing noisier that was before it.
    void anImpactStaysLocal()
    {
        double alone = 0, aloneSigma = 0, before = 0, beforeSigma = 0, mean = 0;
        constexpr int runs = 10;
        for (unsigned seed = 0; seed < runs; ++seed) {
            const auto acceleration = [](const ProfilePoint &point, double) {
                return std::pair(point.acceleration.x() - 0.8, point.sigmaAccelMps2);
            };
            auto samples = measured(slide(1.5), 3, 0.001, seed);
            const std::vector<ProfilePoint> struck = smoothed(samples);
            samples.resize(std::size_t(1.5 * framesPerSecond));
            const Spread clean = errorOf(smoothed(samples), 0.3, 1.2, acceleration),
                         with = errorOf(struck, 0.3, 1.2, acceleration);
            alone += clean.rms / runs;
            aloneSigma += clean.sigma / runs;
            before += with.rms / runs;
            beforeSigma += with.sigma / runs;
            for (int i = 18; i < 72; ++i)
                mean += struck[std::size_t(i)].acceleration.x() / 54 / runs;
        }
        qInfo("noise %.3f and %.3f, σ %.3f and %.3f m/s², mean %.3f", alone, before, aloneSigma, beforeSigma,
              mean);
        // One noise for the whole run made it 1 m/s².
        QVERIFY(before < 1.3 * alone && alone < 0.005);
        QVERIFY(beforeSigma < 1.3 * aloneSigma && beforeSigma > aloneSigma / 1.3);
        QVERIFY(std::abs(mean / 0.8 - 1) < 0.03);
    }

    /// Each regime has the σ that belongs to it.
    void restIsAveragedLongerThanADrive()
    {
        // Rests until 4 s, then drives a lively figure eight.
        const Course eight = figureEight(1, 0.5, 4);
        const Course course = [=](double t) {
            if (t >= 4)
                return eight(t - 4);
            return Truth{};
        };
        double within = 0, restSigma = 0, driveSigma = 0;
        constexpr int runs = 10;
        for (unsigned seed = 0; seed < runs; ++seed) {
            const auto points = smoothed(measured(course, 8, 0.002, seed));
            const auto speed = [&](const ProfilePoint &point, double t) {
                return std::pair((point.velocity - course(t).velocity).norm() / std::sqrt(2.0),
                                 point.sigmaSpeedMps);
            };
            const Spread rest = errorOf(points, 0.5, 3.5, speed), drive = errorOf(points, 4.5, 7.5, speed);
            restSigma += rest.sigma / runs;
            driveSigma += drive.sigma / runs;
            within += (rest.within + drive.within) / 2 / runs;
        }
        qInfo("σ %.2f mm/s at rest, %.2f driving; %.1f %% within 2 σ", 1e3 * restSigma, 1e3 * driveSigma,
              100 * within);
        QVERIFY(restSigma < driveSigma / 5);
        QVERIFY(within > 0.9);
    }

    /// A marker that rocks on its mast does not make the robot faster.
    void aWobbleIsNotDriven()
    {
        const Course straight = [](double t) { return Truth{{0.08 * t, 0}, {0.08, 0}, {0, 0}}; };
        for (unsigned seed = 0; seed < 3; ++seed) {
            const auto speed = [](const ProfilePoint &point, double) {
                return std::pair(point.speedMps - 0.08, point.sigmaSpeedMps);
            };
            const auto samples = measured(straight, 40, 0.0002, seed, 0.0005);
            const Spread taken = errorOf(smoothed(samples), 1, 39, speed),
                         told = errorOf(smoothed(samples, true), 1, 39, speed);
            qInfo("speed to %.2f mm/s, %.2f if the wobble is known of; %.1f %% within 2 σ", 1e3 * taken.rms,
                  1e3 * told.rms, 100 * told.within);
            QVERIFY(told.rms < taken.rms / 3);
            QVERIFY(told.within > 0.9);
        }
    }

    /// A localisation whose error drifts and is pulled back: the truth is inside what is stated, and the
    /// robot's speed is not that of the drift.
    void aDriftIsNotDriven_data()
    {
        QTest::addColumn<double>("sigmaM");
        QTest::addColumn<double>("lastsS");
        // What lasts longer shows its width only in a longer run.
        for (const auto &[sigmaM, lastsS] : {std::pair(0.003, 0.15), {0.01, 0.15}, {0.01, 0.65}})
            QTest::addRow("%.0f mm for %.2f s", 1e3 * sigmaM, lastsS) << sigmaM << lastsS;
    }
    void aDriftIsNotDriven()
    {
        QFETCH(const double, sigmaM);
        QFETCH(const double, lastsS);
        const Course eight = figureEight(0.8, 0.4, 6);
        double inside = 0, rms = 0, sigma = 0;
        constexpr unsigned runs = 8;
        for (unsigned seed = 0; seed < runs; ++seed) {
            const Spread off =
                errorOf(smoothed(drifting(eight, 12, sigmaM, lastsS, seed), true), 0, 12,
                        [&](const ProfilePoint &point, double t) {
                            return std::pair((point.position - eight(t).position).x(), point.sigmaXM);
                        });
            inside += off.within / runs;
            rms += off.rms / runs;
            sigma += off.sigma / runs;
        }
        qInfo("%.1f mm off at a stated %.1f: %.0f %% within 2 σ", 1e3 * rms, 1e3 * sigma, 100 * inside);
        QVERIFY(inside > 0.9);
        QVERIFY(sigma < 4 * sigmaM); // a σ of anything would hold
    }

    /// The robot's own swaying is its motion, and white noise is no wobble.
    void noWobbleIsFoundWhereThereIsNone()
    {
        const Course swaying = [](double t) {
            return Truth{{0.3 * t, 0.01 * std::sin(9 * t)}, {0.3, 0.09 * std::cos(9 * t)}, {0, 0}};
        };
        for (const Course &course : {swaying, figureEight(0.8, 0.4, 6)}) {
            const auto samples = measured(course, 20, 0.001, 5);
            const auto segments = cutIntoSegments(samples, fromSeconds(1));
            const auto nodes = nodesOf(segments);
            const MeasurementNoise found = withWobble(nodes, {}, estimateMotionNoise(nodes, false));
            QCOMPARE(found.wobbleM, 0.0);
        }
    }
};

ODOGRAPH_TEST(TestMotionNoise, QCoreApplication)
#include "tst_motion_noise.moc"
