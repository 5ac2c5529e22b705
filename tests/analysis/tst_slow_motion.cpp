// SPDX-License-Identifier: GPL-3.0-or-later
// Slow robots are measured, and one at rest never moves.
#include "core/analysis/metrics.h"
#include "core/trajectory/imported_track.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <array>
#include <random>

using namespace odo;
using namespace odo::test;

namespace {

constexpr std::array<double, 7> speedsMmps{0, 1, 2, 5, 10, 20, 50};
constexpr std::array<double, 3> noisesMm{0.3, 1, 3};
constexpr double drivenS = 20;

/// How many runs of each: a sample, or with ODOGRAPH_SLOW_RUNS=20 what is claimed (docs/testing.md).
int runsOfEach()
{
    const int told = qEnvironmentVariableIntValue("ODOGRAPH_SLOW_RUNS");
    return told > 0 ? told : 3;
}

/// Along a line for 20 s, or on a wide curve; every third run stands for 4 s before it and after.
Profile analysed(double speedMps, double noiseM, int run)
{
    std::mt19937 random(unsigned(run) + unsigned(1e6 * speedMps) + 1);
    std::normal_distribution<double> noise(0, noiseM);
    const double standsS = run % 3 == 2 ? 4 : 0, turnRadps = run % 2 == 1 ? 0.1 : 0;
    std::vector<ImportedPosition> track;
    for (int i = 0; i <= (drivenS + 2 * standsS) * 30; ++i) {
        const double t = std::clamp(i / 30.0 - standsS, 0.0, drivenS);
        const Eigen::Vector2d place =
            turnRadps > 0
                ? Eigen::Vector2d(speedMps / turnRadps *
                                  Eigen::Vector2d(std::sin(turnRadps * t), 1 - std::cos(turnRadps * t)))
                : Eigen::Vector2d(0.8 * speedMps * t, 0.6 * speedMps * t);
        ImportedPosition row;
        row.time = fromSeconds(i / 30.0);
        row.position = place + Eigen::Vector2d(noise(random), noise(random));
        track.push_back(row);
    }
    const auto raw = samplesOfImported(track, estimateImportedNoiseM(track));
    return analyseImported(raw, optionsForImported({}, raw)).value();
}

} // namespace

class TestSlowMotion : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void itsPathHolds_data()
    {
        QTest::addColumn<double>("speedMps");
        QTest::addColumn<double>("noiseM");
        for (const double speed : speedsMmps)
            for (const double noise : noisesMm)
                QTest::newRow(qPrintable(QStringLiteral("%1 mm/s, %2 mm").arg(speed).arg(noise)))
                    << speed / 1e3 << noise / 1e3;
    }
    void itsPathHolds()
    {
        QFETCH(double, speedMps);
        QFETCH(double, noiseM);
        int holds = 0;
        double error = 0, sigma = 0, stops = 0;
        for (int run = 0; run < runsOfEach(); ++run) {
            const Profile profile = analysed(speedMps, noiseM, run);
            const double path = metricValue(profile, "path_length"), truth = speedMps * drivenS;
            const double stated =
                *std::ranges::find(profile.metrics, std::string("path_length"), &Metric::name)->sigma;
            holds += std::abs(path - truth) <= 2 * stated + 1e-9;
            error += (path - truth) / runsOfEach();
            sigma += stated / runsOfEach();
            stops += metricValue(profile, "stops") / runsOfEach();
            if (speedMps == 0)
                QCOMPARE(path, 0.0);
        }
        qInfo("held in %3.0f %%, error %+.2f mm, sigma %.2f mm, stops %.2f", 100.0 * holds / runsOfEach(),
              1e3 * error, 1e3 * sigma, stops);
        QVERIFY(holds >= (runsOfEach() > 9 ? 0.9 : 0.5) * runsOfEach());
    }
};

ODOGRAPH_TEST(TestSlowMotion, QCoreApplication)
#include "tst_slow_motion.moc"
