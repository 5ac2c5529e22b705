// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/metrics.h"
#include "core/analysis/run_differences.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_run.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

/// Two metres at an even speed; the places have an error of 20 mm that all share.
Profile alongALine(double speedMps)
{
    constexpr double lengthM = 2, commonM = 0.02;
    const Course course = [speedMps](double t) { return Truth{{t * speedMps, 0}, {speedMps, 0}, {0, 0}}; };
    Run run = exactly(course, lengthM / speedMps, 0, Eigen::Matrix2d::Identity() * commonM * commonM);
    Profile profile;
    profile.samples = std::move(run.samples);
    profile.points = std::move(run.points);
    profile.metrics = measureRun(profile.samples, profile.points);
    return profile;
}

} // namespace

/// The figures of two runs side by side.
class TestMetricDifferences : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void metricsDifferByWhatIsBeyondTheirErrors()
    {
        const auto with = [](std::vector<Metric> metrics) {
            Profile profile;
            profile.metrics = std::move(metrics);
            return profile;
        };
        const auto lines = metricDifferences(with({{"duration", "s", 5, 0.03},
                                                   {"stops", "1", 1, {}},
                                                   {"laps", "1", 2, {}},
                                                   {"path_completed", "1", 1, {}},
                                                   {"circle_radius", "m", 1, 0.1}}),
                                             with({{"duration", "s", 5.09, 0.04},
                                                   {"stops", "1", 2, {}},
                                                   {"laps", "1", 2, {}},
                                                   {"path_completed", "1", 0.999, {}}}),
                                             false, true);
        QCOMPARE(lines.size(), std::size_t(5));
        QVERIFY(std::abs(lines[0].difference->value - 0.09) < 1e-12 &&
                std::abs(lines[0].difference->sigma - 0.05) < 1e-12);
        QVERIFY(!lines[0].difference->isSignificant()); // 0.09 < 1.96 · 0.05
        QVERIFY(lines[1].difference->isSignificant() && !lines[2].difference->isSignificant());
        QVERIFY(!lines[3].difference->isSignificant());
        QVERIFY(!lines[4].difference && !lines[4].b);
        QVERIFY((Difference{-0.2, 0.1}.isSignificant()) && !(Difference{0.195, 0.1}.isSignificant()));
        QCOMPARE(metricDifferences(with({{"laps", "1", 2, {}}}), with({{"cross_track_rms", "mm", 2, 1}}),
                                   false, false)
                     .size(),
                 std::size_t(0));
    }

    void lowerBoundsAreNotCompared()
    {
        Profile whole, gaps;
        whole.metrics = {{"path_length", "m", 6, 0.01}, {"mean_speed", "m/s", 1, 0.01}};
        gaps.metrics = {{"path_length", "m", 4, 0.01, true}, {"mean_speed", "m/s", 0.5, 0.01}};
        const auto lines = metricDifferences(whole, gaps, false, true);
        QVERIFY(!lines[0].difference && lines[0].isAtLeastB && !lines[0].isAtLeastA);
        QCOMPARE(lines[0].b.value(), 4.0);
        QVERIFY(lines[1].difference->isSignificant());
        QVERIFY(metricDifferences(gaps, whole, false, true)[0].isAtLeastA);
    }

    void aSharedErrorOfScaleLeavesThePathLengthsAlone()
    {
        // The same way: what the scale does to one length it does to the other.
        const Profile one = alongALine(0.5), two = alongALine(0.4);
        const auto length = [&](bool shared) {
            for (const MetricDifference &line : metricDifferences(one, two, shared, true))
                if (line.name == "path_length")
                    return *line.difference;
            return Difference{};
        };
        const double scale = sigmaOfScale(one.samples, one.points);
        QVERIFY2(std::abs(scale - 0.02 * M_SQRT2 / 2) < 1e-6, qPrintable(QString::number(scale))); // over 2 m
        QVERIFY(std::abs(std::pow(length(false).sigma, 2) - std::pow(length(true).sigma, 2) -
                         std::pow(2 * scale * M_SQRT2, 2)) < 1e-4);
    }
};

ODOGRAPH_TEST(TestMetricDifferences, QCoreApplication)
#include "tst_metric_differences.moc"
