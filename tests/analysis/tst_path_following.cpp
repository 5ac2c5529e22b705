// SPDX-License-Identifier: GPL-3.0-or-later
// Distance from a reference path against closed forms, and its stated σ against the scatter over noisy runs.
#include "core/analysis/internal/path_following.h"
#include "core/analysis/task_metrics.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_run.h"

#include <QTest>
#include <map>

using namespace odo;
using namespace odo::test;

namespace {

std::map<std::string, Metric> metricsOf(const ReferencePath &path, const Run &run)
{
    Task task;
    task.path = path;
    std::map<std::string, Metric> named;
    for (const Metric &metric : measureTask(task, run.samples, run.points).metrics)
        named[metric.name] = metric;
    return named;
}

std::vector<PathPosition> followed(const ReferencePath &path, const Run &run)
{
    return followPath(path, measuredPositions(run.samples, run.points));
}

Course evenly(Eigen::Vector2d from, Eigen::Vector2d velocity)
{
    return [=](double t) { return Truth{from + t * velocity, velocity, {0, 0}}; };
}

/// A circle that is d larger than the path on average and swings by as much about it, four times a turn.
Course wavyCircle(double radiusM, double outM, double swingM, double periodS)
{
    return [=](double t) {
        const double w = 2 * M_PI / periodS, angle = w * t;
        const double r = radiusM + outM + swingM * std::sin(4 * angle),
                     rate = 4 * w * swingM * std::cos(4 * angle);
        const Eigen::Vector2d away(std::cos(angle), std::sin(angle)), aside(-away.y(), away.x());
        return Truth{r * away, rate * away + r * w * aside, -r * w * w * away};
    };
}

const ReferencePath line{{{0, 0}, {2, 0}}, false};

} // namespace

class TestPathFollowing : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theSampledCurvesKeepToTheirFormulas()
    {
        const auto check = [](const ReferencePath &path,
                              const std::function<double(Eigen::Vector2d)> &error) {
            double worst = 0;
            const std::size_t count = path.points.size();
            for (std::size_t i = 0; i + (path.closed ? 0 : 1) < count; ++i) {
                const Eigen::Vector2d middle = (path.points[i] + path.points[(i + 1) % count]) / 2;
                worst = std::max(worst, error(middle));
            }
            QVERIFY2(worst < 6e-5 && count <= 5000, qPrintable(QString::number(worst * 1e3)));
        };
        for (const double r : {0.2, 0.5, 5.0})
            check(circlePath({1, 1}, r),
                  [r](Eigen::Vector2d p) { return std::abs((p - Eigen::Vector2d(1, 1)).norm() - r); });
        // Distance from an implicit curve f = 0, to first order |f| / |grad f|.
        check(figureEightPath({0, 0}, 0.95, 0.6), [](Eigen::Vector2d p) {
            const double x = p.x() / 0.95, y = p.y() / 0.6; // y² = 4x²(1 − x²)
            const double f = y * y - 4 * x * x * (1 - x * x);
            return std::abs(f) / Eigen::Vector2d((16 * x * x * x - 8 * x) / 0.95, 2 * y / 0.6).norm();
        });
        check(slalomPath({0, 0}, {3, 0}, 4, 0.25), [](Eigen::Vector2d p) {
            const double k = 4 * M_PI / 3;
            return std::abs(p.y() - 0.25 * std::sin(k * p.x())) /
                   std::hypot(1, 0.25 * k * std::cos(k * p.x()));
        });
        QVERIFY(std::abs(lengthOf(circlePath({1, 1}, 0.5)) - M_PI) < 1e-3);
        QCOMPARE(lengthOf(line), 2.0);
    }
    void besideALineInClosedForm()
    {
        // 40 mm to the left of it, from 0.3 m before its start to 0.2 m past its end.
        const Run run = exactly(evenly({-0.3, 0.04}, {0.5, 0}), 5);
        const auto positions = followed(line, run);
        QVERIFY(positions.front().beyondEnd && positions.back().beyondEnd && !positions[60].beyondEnd);
        QVERIFY(std::abs(positions[60].stationM - 0.7) < 1e-9);
        QVERIFY(std::abs(positions[60].offsetM - 0.04) < 1e-12);
        auto figures = metricsOf(line, run);
        for (const char *name :
             {"cross_track_mean", "cross_track_rms", "cross_track_max", "cross_track_bias"})
            QVERIFY2(std::abs(figures[name].value - 40) < 1e-6, name);
        QCOMPARE(figures["path_completed"].value, 1.0);
        const auto right = metricsOf(line, exactly(evenly({-0.3, -0.04}, {0.5, 0}), 5));
        QVERIFY(std::abs(right.at("cross_track_bias").value + 40) < 1e-6);
        QVERIFY(std::abs(right.at("cross_track_mean").value - 40) < 1e-6);
    }
    void halfTheWayIsHalfThePath()
    {
        const auto figures = metricsOf(line, exactly(evenly({0, 0.01}, {0.5, 0}), 2));
        QVERIFY(std::abs(figures.at("path_completed").value - 0.5) < 0.002);
        // To and fro twice over the first half is still half.
        const Course swing = [](double t) {
            return Truth{{0.5 - 0.5 * std::cos(2 * t), 0}, {std::sin(2 * t), 0}, {2 * std::cos(2 * t), 0}};
        };
        QVERIFY(std::abs(metricsOf(line, exactly(swing, 6.3)).at("path_completed").value - 0.5) < 0.002);
    }
    void aPauseWeighsNothing()
    {
        // 1 m exactly on the line, a pause 50 mm aside of two thirds of the time, 1 m at 50 mm.
        const Course course = [](double t) {
            Truth truth;
            truth.velocity = {t < 2 || t > 10 ? 0.5 : 0, 0};
            truth.position = {t < 2 ? 0.5 * t : t < 10 ? 1.0 : 1 + 0.5 * (t - 10), t < 2 ? 0 : 0.05};
            return truth;
        };
        const auto figures = metricsOf(line, exactly(course, 12));
        QVERIFY2(std::abs(figures.at("cross_track_mean").value - 25) < 0.6,
                 qPrintable(QString::number(figures.at("cross_track_mean").value)));
    }
    void roundACircleInClosedForm()
    {
        // 30 mm outside with a swing of 20 mm: mean 30, RMS √(30² + 20²/2), most 50 mm; outside is right.
        const auto figures = metricsOf(circlePath({0, 0}, 0.5), exactly(wavyCircle(0.5, 0.03, 0.02, 4), 12));
        QVERIFY(std::abs(figures.at("cross_track_mean").value - 30) < 0.4);
        QVERIFY(std::abs(figures.at("cross_track_bias").value + 30) < 0.4);
        QVERIFY(std::abs(figures.at("cross_track_rms").value - std::sqrt(30 * 30 + 20 * 20 / 2)) < 0.4);
        QVERIFY(std::abs(figures.at("cross_track_max").value - 50) < 0.1);
        QCOMPARE(figures.at("path_completed").value, 1.0);
    }
    void theStationGoesOnAtTheCrossingOfAFigureEight()
    {
        const Course course = figureEight(0.95, 0.6, 6);
        const ReferencePath path = figureEightPath({0, 0}, 0.95, 0.6);
        const double length = lengthOf(path);
        for (unsigned seed = 0; seed < 10; ++seed) {
            std::mt19937 random(seed);
            const Run run = smoothed(course, 18, 0.004, random);
            double gone = 0;
            const auto positions = followed(path, run);
            for (std::size_t i = 1; i < positions.size(); ++i) {
                QVERIFY(!positions[i].jumped);
                const double step = std::remainder(positions[i].stationM - positions[i - 1].stationM, length);
                QVERIFY(std::abs(step) < 0.08);
                gone += step;
            }
            QVERIFY2(std::abs(gone / length - 3) < 0.01, qPrintable(QString::number(gone / length)));
            QCOMPARE(metricsOf(path, run).at("path_completed").value, 1.0);
        }
    }
    void aShortCutIsAJumpAndNotCounted()
    {
        // Round the right loop of the eight twice, never the left one.
        const Course course = figureEight(0.95, 0.6, 6);
        const Course right = [course](double t) { return course(std::fmod(t, 3.0)); };
        const auto positions = followed(figureEightPath({0, 0}, 0.95, 0.6), exactly(right, 6));
        const auto jumps =
            std::count_if(positions.begin(), positions.end(), [](const PathPosition &p) { return p.jumped; });
        QCOMPARE(jumps, 1);
        QVERIFY(std::abs(completedShare(figureEightPath({0, 0}, 0.95, 0.6), positions) - 0.5) < 0.02);
    }
    void aRobotThatNeverMovesHasNoDistance()
    {
        const auto figures = metricsOf(line, exactly(evenly({1, 0.1}, {0, 0}), 3, 0.001));
        QCOMPARE(figures.size(), std::size_t(1));
        QCOMPARE(figures.at("path_completed").value, 0.0);
        QCOMPARE(metricsOf(line, {}).at("path_completed").value, 0.0);
    }
    void theCalibrationsShiftIsInTheSigma()
    {
        Eigen::Matrix2d common;
        common << 0, 0, 0, 0.006 * 0.006; // across the line only
        const auto figures = metricsOf(line, exactly(evenly({0, 0.04}, {0.5, 0}), 4, 0, common));
        for (const char *name :
             {"cross_track_mean", "cross_track_rms", "cross_track_max", "cross_track_bias"})
            QVERIFY2(std::abs(*figures.at(name).sigma - 6) < 1e-6, name);
    }
    void theStatedSigmaIsTheScatter_data()
    {
        QTest::addColumn<double>("swingM");
        QTest::addColumn<double>("outM");
        QTest::newRow("well off the path") << 0.03 << 0.06;
        QTest::newRow("to and fro over it") << 0.05 << 0.0;
    }
    void theStatedSigmaIsTheScatter()
    {
        QFETCH(double, swingM);
        QFETCH(double, outM);
        const Course course = wavyCircle(0.5, outM, swingM, 5);
        const ReferencePath path = circlePath({0, 0}, 0.5);
        auto truth = metricsOf(path, exactly(course, 10));
        std::map<std::string, double> squares, stated;
        for (unsigned seed = 0; seed < 100; ++seed) {
            std::mt19937 random(seed);
            for (const auto &[name, metric] : metricsOf(path, smoothed(course, 10, 0.003, random))) {
                if (!metric.sigma)
                    continue;
                squares[name] += std::pow(metric.value - truth[name].value, 2);
                stated[name] += *metric.sigma * *metric.sigma;
            }
        }
        for (const auto &[name, sum] : squares) {
            const double ratio = std::sqrt(sum / stated[name]);
            qInfo("%s: scatter %.3f mm, over stated %.2f", name.c_str(), std::sqrt(sum / 100), ratio);
            QVERIFY2(ratio > 0.6 && ratio < 1.25, name.c_str());
        }
    }
    void noiseAloneIsNotClaimedToBeADistance()
    {
        // Exactly on the path: the mean magnitude is all noise, and its σ reaches down to zero.
        std::mt19937 random(3);
        const auto figures = metricsOf(line, smoothed(evenly({0, 0}, {0.5, 0}), 4, 0.004, random));
        for (const char *name : {"cross_track_mean", "cross_track_rms"}) {
            const Metric &metric = figures.at(name);
            QVERIFY2(metric.value < 2.5 * *metric.sigma, name);
            QVERIFY2(metric.value < 2, name);
        }
        QVERIFY(std::abs(figures.at("cross_track_bias").value) < 3 * *figures.at("cross_track_bias").sigma);
    }
};

ODOGRAPH_TEST(TestPathFollowing, QCoreApplication)
#include "tst_path_following.moc"
