// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/turning_smoother.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <functional>
#include <random>

using namespace odo;

namespace {

using TurnRate = std::function<double(double timeS)>;

struct Turning
{
    std::vector<TurnNode> nodes;
    std::vector<double> radians, rates; ///< the truth
};

Turning turningOf(const TurnRate &rate, double perSecond, double noiseRad, std::uint32_t seed = 3)
{
    constexpr double stepS = 1e-4, durationS = 10;
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 1);
    Turning turning;
    double heading = 0.3, timeS = 0;
    for (int i = 0; i <= durationS * perSecond; ++i) {
        for (; timeS + stepS / 2 < i / perSecond; timeS += stepS)
            heading += stepS * rate(timeS + stepS / 2);
        turning.radians.push_back(heading);
        turning.rates.push_back(rate(timeS));
        turning.nodes.push_back(
            {timeS, true, heading + noiseRad * noise(random), std::pow(std::max(noiseRad, 1e-4), 2)});
    }
    return turning;
}

double atOnce(double timeS)
{
    return timeS > 2.02 && timeS < 5.02 ? 3 : timeS > 6.02 && timeS < 8.02 ? -3 : 0;
}
double inAWave(double timeS)
{
    return 3 * std::cos(1.5 * timeS);
}

struct Coverage
{
    double heading = 0, rate = 0;
    double fastestAway = 0; ///< of the surest fastest rate from the true one, in σ
};

Coverage coverageOf(const Turning &turning, const std::vector<TurnEstimate> &estimates)
{
    Coverage coverage;
    const TurnEstimate *fastest = &estimates.front();
    const auto sure = [](const TurnEstimate &one) {
        return std::abs(one.rateRadps) - 2 * one.sigmaRateRadps;
    };
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const TurnEstimate &one = estimates[i];
        coverage.heading += std::abs(one.radians - turning.radians[i]) <= 2 * one.sigmaRad;
        coverage.rate += std::abs(one.rateRadps - turning.rates[i]) <= 2 * one.sigmaRateRadps;
        if (sure(one) > sure(*fastest))
            fastest = &one;
    }
    coverage.heading /= double(estimates.size());
    coverage.rate /= double(estimates.size());
    coverage.fastestAway = (std::abs(fastest->rateRadps) - 3) / fastest->sigmaRateRadps;
    return coverage;
}

} // namespace

class TestTurningSmoother : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void statedErrorsHold_data()
    {
        QTest::addColumn<bool>("isWave");
        QTest::addColumn<double>("perSecond");
        QTest::addColumn<double>("noiseRad");
        for (const bool isWave : {false, true})
            for (const double perSecond : {10.0, 30.0, 100.0})
                for (const double noiseRad : {0.0, 0.002, 0.02})
                    QTest::addRow("%s, %g a second, %g rad", isWave ? "in a wave" : "at once", perSecond,
                                  noiseRad)
                        << isWave << perSecond << noiseRad;
    }
    void statedErrorsHold()
    {
        QFETCH(bool, isWave);
        QFETCH(double, perSecond);
        QFETCH(double, noiseRad);
        double heading = 0, rate = 0;
        constexpr int runs = 5;
        for (std::uint32_t seed = 1; seed <= runs; ++seed) {
            const Turning turning = turningOf(isWave ? inAWave : atOnce, perSecond, noiseRad, seed);
            const Coverage coverage = coverageOf(turning, smoothTurning({turning.nodes})[0]);
            heading += coverage.heading / runs;
            rate += coverage.rate / runs;
            QVERIFY2(std::abs(coverage.fastestAway) < 2.5, qPrintable(QString::number(coverage.fastestAway)));
        }
        QVERIFY2(heading > 0.9 && rate > 0.9, qPrintable(QStringLiteral("%1, %2").arg(heading).arg(rate)));
    }

    /// What is stated of the measurements is not known so well.
    void theScaleIsEstimated()
    {
        for (const double factor : {0.25, 1.0, 9.0}) {
            Turning turning = turningOf(inAWave, 50, 0.01);
            for (TurnNode &node : turning.nodes)
                node.variance /= factor;
            const double scale = turnNoiseScale({turning.nodes});
            QVERIFY2(std::abs(scale / factor - 1) < 0.3, qPrintable(QString::number(scale)));
        }
        QCOMPARE(turnNoiseScale({}), 1.0);
    }

    void outliersAndGapsStayWhereTheyAre()
    {
        Turning turning = turningOf(atOnce, 30, 0.005);
        const auto before = smoothTurning({turning.nodes})[0];
        for (const std::size_t i : {100U, 101U, 200U})
            turning.nodes[i].radians += 0.7;
        for (std::size_t i = 220; i < 228; ++i)
            turning.nodes[i].measured = false;
        const auto after = smoothTurning({turning.nodes})[0];
        QCOMPARE(after.size(), turning.nodes.size());
        for (const std::size_t i : {20U, 99U, 102U, 150U, 201U, 290U})
            QVERIFY2(std::abs(after[i].radians - turning.radians[i]) < 0.03,
                     qPrintable(QString::number(after[i].radians - turning.radians[i])));
        QVERIFY(std::abs(after[224].radians - turning.radians[224]) < 2 * after[224].sigmaRad);
        QVERIFY(after[224].sigmaRad > 2 * before[224].sigmaRad);
    }

    void segmentsDoNotTouch()
    {
        const Turning first = turningOf(atOnce, 30, 0.005), second = turningOf(inAWave, 30, 0.005, 4);
        const auto both = smoothTurning({first.nodes, second.nodes});
        QCOMPARE(both.size(), std::size_t(2));
        QVERIFY(coverageOf(first, both[0]).heading > 0.9 && coverageOf(second, both[1]).heading > 0.9);
        QVERIFY(smoothTurning({}).empty());
    }
};

ODOGRAPH_TEST(TestTurningSmoother, QCoreApplication)
#include "tst_turning_smoother.moc"
