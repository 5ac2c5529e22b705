// SPDX-License-Identifier: GPL-3.0-or-later
// What low-pass filters take away of a run: against the filter's closed form, and known noise.
#include "core/analysis/smoothing/cutoff_residuals.h"
#include "core/trajectory/internal/track_profile.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace odo;

namespace {

constexpr double rate = 50;

/// What two passes let through of a frequency, by the bilinear transform.
double gain(double hz, double cutoffHz)
{
    const double x = std::tan(M_PI * hz / rate) / std::tan(M_PI * cutoffHz / rate);
    return 1 / (1 + (std::sqrt(2.0) - 1) * std::pow(x, 4)); // −3 dB at the cut-off
}

Profile run(double sigmaM, double swingM, std::uint32_t seed, double seconds = 20, double jerkDensity = 0.5)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 1);
    Profile profile;
    for (int i = 0; i <= int(seconds * rate); ++i) {
        const double t = i / rate;
        Sample sample;
        sample.frame = i;
        sample.time = fromSeconds(t);
        sample.position = Eigen::Vector2d(swingM * std::sin(2 * M_PI * 0.7 * t) + sigmaM * noise(random),
                                          0.3 * t + sigmaM * noise(random));
        sample.covariance = Eigen::Matrix2d::Identity() * std::max(1e-12, sigmaM * sigmaM);
        profile.samples.push_back(sample);
    }
    profile.points = makePoints(profile.samples, {}, {}, {jerkDensity, 1});
    return profile;
}

} // namespace

class TestCutoffResiduals : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theFilterHasItsClosedForm()
    {
        for (const double cutoff : {2.0, 6.0, 12.0})
            for (const double hz : {0.5, 2.0, 6.0, 11.0}) {
                std::vector<double> wave;
                for (int i = 0; i < 1000; ++i)
                    wave.push_back(std::sin(2 * M_PI * hz * i / rate + 0.3));
                const std::vector<double> filtered = butterworth(wave, rate, cutoff);
                QCOMPARE(filtered.size(), wave.size());
                double most = 0;
                for (std::size_t i = 300; i < 700; ++i) // far from the ends, and without a delay
                    most = std::max(most, std::abs(filtered[i] - gain(hz, cutoff) * wave[i]));
                QVERIFY2(most < 1e-6, qPrintable(QString::number(most)));
            }
    }
    void straightMotionStays()
    {
        std::vector<double> line;
        for (int i = 0; i < 300; ++i)
            line.push_back(2 + 0.01 * i);
        const std::vector<double> filtered = butterworth(line, rate, 3);
        for (std::size_t i = 0; i < line.size(); ++i)
            QVERIFY(std::abs(filtered[i] - line[i]) < 1e-3); // a tenth of a step
        QCOMPARE(butterworth({1.5}, rate, 3), std::vector<double>{1.5});
        QVERIFY(butterworth({}, rate, 3).empty());
        QCOMPARE(butterworth({1, 2}, rate, 3).size(), std::size_t(2));
    }
    /// Of white noise of 2 mm R² = σ²·(1/f_N)∫(1 − gain)² df.
    void whiteNoiseIsTakenAwayByItsShare()
    {
        const CutoffAnalysis analysis = cutoffAnalysis(run(0.002, 0, 3, 60));
        QCOMPARE(analysis.framesPerSecond, rate);
        QCOMPARE(analysis.residuals.size(), std::size_t(40));
        for (const CutoffResidual &each : analysis.residuals) {
            double share = 0;
            constexpr int steps = 2000;
            for (int i = 0; i < steps; ++i)
                share += std::pow(1 - gain((i + 0.5) / steps * rate / 2, each.cutoffHz), 2) / steps;
            const double expected = 0.002 * std::sqrt(share);
            QVERIFY2(std::abs(each.residualM - expected) < 4 * each.sigmaM,
                     qPrintable(QStringLiteral("%1 Hz: %2 %3 ± %4")
                                    .arg(each.cutoffHz)
                                    .arg(each.residualM)
                                    .arg(expected)
                                    .arg(each.sigmaM)));
        }
    }
    void theNoiseIsFound()
    {
        int inside = 0;
        for (std::uint32_t seed = 1; seed <= 40; ++seed) {
            const CutoffAnalysis analysis = cutoffAnalysis(run(0.002, 0.2, seed));
            QVERIFY(analysis.noiseM && analysis.chosenHz);
            // 2000 coordinates, half of whose noise is taken away: 2.2 %
            QVERIFY2(std::abs(analysis.noiseM->value - 0.002) < 0.1 * 0.002,
                     qPrintable(QString::number(analysis.noiseM->value)));
            inside += std::abs(analysis.noiseM->value - 0.002) < 3 * analysis.noiseM->sigma;
            // Above the motion, and far below the noise's end.
            QVERIFY(analysis.chosenHz->value > 0.7 && analysis.chosenHz->value < 12);
            QVERIFY(analysis.chosenHz->sigma > 0 && analysis.chosenHz->sigma < 5);
        }
        qInfo("noise within 3 sigma: %d of 40", inside);
        QVERIFY(inside >= 36);
    }
    /// ω₀⁶ = q/r with r = σ²Δt: the smoother lets through 1/(1 + (ω/ω₀)⁶).
    void theAutomaticCutoffIsThatOfItsNoise()
    {
        for (const double density : {0.05, 0.5, 20.0}) {
            const CutoffAnalysis analysis = cutoffAnalysis(run(0.002, 0.2, 1, 20, density));
            const double rate0 = std::pow(density / (0.002 * 0.002 / rate), 1.0 / 6);
            const double expected = std::pow(std::sqrt(2.0) - 1, 1.0 / 6) * rate0 / (2 * M_PI);
            QVERIFY2(std::abs(analysis.automaticHz->value / expected - 1) < 0.05,
                     qPrintable(QStringLiteral("%1 %2").arg(analysis.automaticHz->value).arg(expected)));
            QVERIFY(analysis.automaticResidualM->value > 0.0015 &&
                    analysis.automaticResidualM->value < 0.0025);
            QVERIFY(std::abs(analysis.statedNoiseM - 0.002) < 1e-9);
        }
    }
    void gapsAndShortRuns()
    {
        Profile gappy = run(0.002, 0.2, 2);
        for (const std::size_t i : {100u, 101u, 300u})
            gappy.samples[i].flags = flagBit(SampleFlag::Lost);
        for (std::size_t i = 500; i < 540; ++i)
            gappy.samples[i].flags = flagBit(SampleFlag::Lost);
        const CutoffAnalysis analysis = cutoffAnalysis(gappy);
        QVERIFY(std::abs(analysis.noiseM->value - 0.002) < 0.1 * 0.002);
        QVERIFY(cutoffAnalysis(run(0.002, 0.2, 2, 0.5)).residuals.empty());
        QVERIFY(cutoffAnalysis({}).residuals.empty());
        Profile lost = run(0.002, 0.2, 2);
        for (Sample &sample : lost.samples)
            sample.position.reset();
        QVERIFY(cutoffAnalysis(lost).residuals.empty());
    }
};

ODOGRAPH_TEST(TestCutoffResiduals, QCoreApplication)
#include "tst_cutoff_residuals.moc"
