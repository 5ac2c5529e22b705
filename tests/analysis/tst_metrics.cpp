// SPDX-License-Identifier: GPL-3.0-or-later
// Every stated σ of a metric against the scatter of that metric over many noisy runs of known truth.
#include "core/analysis/metric_table.h"
#include "core/analysis/metrics.h"
#include "core/analysis/motion_stretches.h"
#include "core/analysis/task_metrics.h"
#include "core/trajectory/internal/track_profile.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>
#include <map>

using namespace odo;
using namespace odo::test;

namespace {

/// Rests a second, speeds up evenly along a circle, runs, brakes evenly, rests.
Course circleWithRests(double radiusM, double accelMps2, double speedMps, double runS)
{
    return [=](double t) {
        const double ramp = speedMps / accelMps2, u = std::clamp(t - 1, 0.0, 2 * ramp + runS);
        double path = 0;
        if (u < ramp)
            path = accelMps2 * u * u / 2;
        else if (u < ramp + runS)
            path = speedMps * (u - ramp / 2);
        else
            path = speedMps * (ramp + runS) - accelMps2 * std::pow(2 * ramp + runS - u, 2) / 2;
        Truth truth;
        truth.position = radiusM * Eigen::Vector2d(std::cos(path / radiusM), std::sin(path / radiusM));
        return truth;
    };
}

/// Swings to and fro along x with a speed that varies.
Course wave()
{
    return [](double t) {
        Truth truth;
        truth.position = {0.9 * std::sin(1.1 * t), 0.3 * std::sin(0.7 * t)};
        return truth;
    };
}

/// Without the frames between two times, in which the clock may go on.
std::vector<Metric> measured(const Course &course, double durationS, double sigmaM, std::mt19937 &random,
                             double jerkDensity = 20, double fromS = 0, double toS = 0)
{
    std::vector<Sample> samples;
    std::normal_distribution<double> noise(0, sigmaM);
    for (int i = 0; i < durationS * 30; ++i) {
        Sample sample;
        if (i / 30.0 > fromS && i / 30.0 < toS)
            continue;
        sample.frame = i;
        sample.time = fromSeconds(i / 30.0);
        sample.position = course(i / 30.0).position + Eigen::Vector2d(noise(random), noise(random));
        sample.covariance = Eigen::Matrix2d::Identity() * sigmaM * sigmaM;
        samples.push_back(sample);
    }
    const auto points = makePoints(samples, {}, {}, {jerkDensity, 1});
    return measureRun(samples, points);
}

std::map<std::string, Metric> byName(const std::vector<Metric> &metrics)
{
    std::map<std::string, Metric> named;
    for (const Metric &metric : metrics)
        named[metric.name] = metric;
    return named;
}

} // namespace

class TestMetrics : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aCircleInClosedForm()
    {
        // 0.5 m radius, 2 m/s² to 0.8 m/s, 4 s even: path 0.8·4.4 m, duration 4.8 s.
        std::mt19937 random(1);
        auto metrics = byName(measured(circleWithRests(0.5, 2, 0.8, 4), 7, 0.0005, random));
        const auto near = [&](const char *name, double value, double tolerance) {
            const bool is = metrics.contains(name) && std::abs(metrics[name].value - value) <= tolerance;
            if (!is)
                qWarning("%s is %f", name, metrics.contains(name) ? metrics[name].value : 0.0);
            return is;
        };
        QVERIFY(near("path_length", 3.52, 0.01));
        QVERIFY(near("duration", 4.8, 0.08));
        QVERIFY(near("median_speed", 0.8, 0.01));
        QVERIFY(near("p95_speed", 0.8, 0.03));
        QVERIFY(near("max_speed", 0.8, 0.03));
        QVERIFY(near("circle_radius", 0.5, 0.002));
        QVERIFY(near("stops", 0, 0));
        QVERIFY(near("standing_time", 0, 1e-9));
        const double chord = 2 * 0.5 * std::abs(std::sin(3.52 / 0.5 / 2));
        QVERIFY(near("straightness", chord / 3.52, 0.01));
    }

    void stopsAndTheTimeStood()
    {
        // Three runs of 1 s along x with rests of 1.5 s between.
        const Course course = [](double t) {
            const int leg = static_cast<int>(std::max(0.0, t - 0.5) / 2.5);
            const double u = std::min(std::max(0.0, t - 0.5) - 2.5 * leg, 1.0);
            Truth truth;
            truth.position.x() = -1 + 0.6 * (leg > 2 ? 3 : leg + u * u * (3 - 2 * u));
            return truth;
        };
        std::mt19937 random(2);
        auto metrics = byName(measured(course, 8, 0.0005, random));
        QCOMPARE(metrics["stops"].value, 2.0);
        QVERIFY2(std::abs(metrics["standing_time"].value - 3) < 0.15,
                 qPrintable(QString::number(metrics["standing_time"].value)));
        QVERIFY(std::abs(metrics["moving_time"].value + metrics["standing_time"].value -
                         metrics["duration"].value) < 1e-9);
        QCOMPARE(metrics.count("circle_radius"), std::size_t(0));
    }

    /// Even speed on a circle of one turn in 6.28 s; 4 s of the second turn have no frames.
    void aGapIsNotDriven()
    {
        std::mt19937 random(3);
        auto metrics = byName(measured(circleWithRests(0.5, 2, 0.5, 12), 15, 0.0005, random, 20, 6, 10));
        const double whole = 0.5 * 12.25;
        QVERIFY2(std::abs(metrics["path_length"].value - (whole - 4 * 0.5)) < 0.02,
                 qPrintable(QString::number(metrics["path_length"].value)));
        QVERIFY(metrics["path_length"].isAtLeast);
        QVERIFY(std::abs(metrics["mean_speed"].value - (whole - 2) / (12.5 - 4)) < 0.01);
        QVERIFY(!metrics["mean_speed"].isAtLeast);
        QVERIFY(std::abs(metrics["duration"].value - 12.5) < 0.1);
        QCOMPARE(metrics["stops"].value, 0.0);
        QVERIFY(metrics["stops"].isAtLeast);
        QVERIFY(metrics["standing_time"].value < 0.1);
        QCOMPARE(metrics.count("straightness"), std::size_t(0));
    }

    /// It stands when it is seen again, and stood when it was seen last: whether it moved meanwhile is not
    /// known.
    void aPauseWithAGapIsNoStop()
    {
        const Course course = [](double t) {
            Truth truth;
            truth.position.x() = 0.4 * (std::clamp(t, 0.0, 2.0) + std::clamp(t - 8, 0.0, 2.0));
            return truth;
        };
        std::mt19937 random(4);
        auto metrics = byName(measured(course, 11, 0.0005, random, 20, 3, 6));
        QCOMPARE(metrics["stops"].value, 0.0);
        QVERIFY2(std::abs(metrics["path_length"].value - 1.6) < 0.03,
                 qPrintable(QString::number(metrics["path_length"].value)));
        QVERIFY(std::abs(metrics["standing_time"].value - 3) < 0.3);
    }

    /// At 0.4 m/s along x; for 1.2 s nothing is measured, and meanwhile it went on, or it stood for 0.2 s.
    void whatABridgedStretchMayHideIsSaid()
    {
        std::mt19937 random(5);
        const auto driving = [](double standsFromS, double standsUntilS) -> Course {
            return [=](double t) {
                constexpr double step = 0.002, rampS = 0.5;
                Truth truth;
                for (double at = 0; at < t; at += step)
                    truth.position.x() +=
                        0.4 * step *
                        std::clamp(std::min((at - 1) / rampS, std::max((standsFromS - at) / rampS,
                                                                       (at - standsUntilS) / rampS)),
                                   0.0, 1.0);
                return truth;
            };
        };
        auto metrics = byName(measured(driving(100, 100), 7, 0.0005, random, 20, 3, 4.2));
        QVERIFY(std::abs(metrics["path_length"].value - 2.3) < 0.02);
        QVERIFY(!metrics["path_length"].isAtLeast && !metrics["stops"].isAtLeast);
        QCOMPARE(metrics["stops"].value, 0.0);
        metrics = byName(measured(driving(3.5, 3.7), 7, 0.0005, random, 20, 3, 4.2));
        QCOMPARE(metrics["stops"].value, 0.0);
        QVERIFY(metrics["stops"].isAtLeast);
        QVERIFY(std::abs(metrics["path_length"].value - 2.02) < 2 * *metrics["path_length"].sigma);
        // It is at rest before and after, at one place: it stood.
        const Course waiting = [](double t) {
            Truth truth;
            truth.position.x() = 0.4 * std::clamp(t - 4, 0.0, 2.0);
            return truth;
        };
        metrics = byName(measured(waiting, 8, 0.0005, random, 20, 1, 2.2));
        QVERIFY(!metrics["stops"].isAtLeast && *metrics["path_length"].sigma < 0.005);
    }

    /// A position every two seconds is a slow track, and a missing one no gap yet; five are.
    void slowTracksHaveOtherGaps()
    {
        GapWatch watch;
        QVERIFY(!watch.joins(0)); // there is nothing before it
        for (const double timeS : {2.0, 4.0, 8.0, 10.0, 12.0})
            QVERIFY(watch.joins(timeS));
        QVERIFY(!watch.joins(24));
        QVERIFY(watch.joins(26));
        watch.skip();
        QVERIFY(!watch.joins(28));
    }

    /// Whatever a run and a task are measured by has its row, with the same unit.
    void theTableHasEachMetric()
    {
        std::vector<Sample> samples;
        const Course course = circleWithRests(0.5, 2, 0.8, 12);
        for (int i = 0; i < 13 * 30; ++i) {
            Sample sample;
            sample.time = fromSeconds(i / 30.0);
            sample.position = course(i / 30.0).position;
            sample.covariance = Eigen::Matrix2d::Identity() * 1e-8;
            samples.push_back(sample);
        }
        const auto points = makePoints(samples, {}, {}, {20, 1});
        Task task;
        task.gates = {{"line", GateRole::StartFinish, {-0.8, 0}, {-0.2, 0}}};
        task.path.points = {{0.5, 0}, {0, 0.5}, {-0.5, 0}, {0, -0.5}};
        task.path.closed = true;
        task.zones = {{"field", ZoneRule::StayInside, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}};
        std::vector<Metric> metrics = measureRun(samples, points);
        const TaskMetrics ofTask = measureTask(task, samples, points);
        metrics.insert(metrics.end(), ofTask.metrics.begin(), ofTask.metrics.end());
        QVERIFY(metrics.size() > 20);
        for (const Metric &metric : metrics) {
            const MetricKind *kind = metricKind(metric.name);
            QVERIFY2(kind, metric.name.c_str());
            QCOMPARE(std::string(kind->unit), metric.unit);
            QVERIFY2(metric.sigma || kind->uncertainty.isEmpty() || metric.value == 0, metric.name.c_str());
        }
        for (const Metric &metric : ofTask.metrics)
            QVERIFY2(metricKind(metric.name)->isOfTask(), metric.name.c_str());
        QVERIFY(!metricKind("of a later version"));
    }

    void sigmasAgreeWithMonteCarlo_data()
    {
        QTest::addColumn<int>("motion");
        QTest::addColumn<QStringList>("names");
        QTest::newRow("circle with rests")
            << 0 << QStringList{QStringLiteral("path_length"),  QStringLiteral("duration"),
                                QStringLiteral("mean_speed"),   QStringLiteral("circle_radius"),
                                QStringLiteral("straightness"), QStringLiteral("max_speed")};
        QTest::newRow("wave") << 1
                              << QStringList{QStringLiteral("median_speed"), QStringLiteral("p95_speed"),
                                             QStringLiteral("path_length")};
    }
    void sigmasAgreeWithMonteCarlo()
    {
        QFETCH(int, motion);
        QFETCH(QStringList, names);
        const Course course = motion == 0 ? circleWithRests(0.5, 2, 0.8, 4) : wave();
        std::mt19937 random(7);
        constexpr int runs = 150;
        std::map<std::string, std::vector<double>> values, sigmas;
        for (int run = 0; run < runs; ++run) {
            for (const Metric &metric : measured(course, 7, 0.002, random, motion == 0 ? 20 : 3)) {
                values[metric.name].push_back(metric.value);
                sigmas[metric.name].push_back(metric.sigma.value_or(0));
            }
        }
        // The closed form of aCircleInClosedForm, where there is one: a metric may have a bias.
        const std::map<std::string, double> truths{
            {"path_length", 3.52}, {"duration", 4.8}, {"mean_speed", 3.52 / 4.8}, {"max_speed", 0.8}};
        bool good = true;
        for (const QString &name : names) {
            const auto &all = values[name.toStdString()];
            double mean = 0, variance = 0, stated = 0;
            for (std::size_t i = 0; i < all.size(); ++i) {
                mean += all[i] / double(all.size());
                stated += sigmas[name.toStdString()][i] / double(all.size());
            }
            if (const auto truth = truths.find(name.toStdString()); motion == 0 && truth != truths.end())
                mean = truth->second;
            for (const double value : all)
                variance += (value - mean) * (value - mean) / double(all.size() - 1);
            const double ratio = stated / std::sqrt(variance);
            qInfo("%s: stated over true σ %.2f", qPrintable(name), ratio);
            // The smoother of a whole analysis adapts to the motion: it blurs the ends more than this one and
            // swings more where the robot stops hard.
            const bool isOfEnds = motion == 0 && truths.contains(name.toStdString());
            good &= all.size() > runs * 0.95 && ratio > 0.7 && ratio < (isOfEnds ? 2.5 : 1.5);
        }
        QVERIFY(good);
    }

    /// The largest of many equal speeds exceeds them by its noise: ± says so.
    void theTopOfAnEvenSpeedHolds()
    {
        std::mt19937 random(11);
        constexpr int runs = 100;
        int inside = 0;
        for (int run = 0; run < runs; ++run) {
            const Metric top =
                byName(measured(circleWithRests(0.5, 2, 0.8, 4), 7, 0.002, random))["max_speed"];
            inside += std::abs(top.value - 0.8) < 2 * *top.sigma;
        }
        QVERIFY2(inside >= 95, qPrintable(QString::number(inside)));
    }

    /// A rate that is hardly known is not the fastest; but the robot may have turned as fast.
    void aTurnThatIsHardlyKnownMayBeFaster()
    {
        const auto fastestTurn = [](double rate, double sigma) {
            std::vector<Sample> samples(30);
            std::vector<ProfilePoint> points(30);
            for (std::size_t i = 0; i < points.size(); ++i) {
                samples[i].time = fromSeconds(double(i) / 30);
                samples[i].position = points[i].position = Eigen::Vector2d::Zero();
                points[i].velocity = points[i].acceleration = Eigen::Vector2d::Zero();
                points[i].valid = true;
                points[i].body = {0, 0.01, 1, 0.05};
            }
            points[15].body = {0, 0.01, rate, sigma};
            return byName(measureRun(samples, points))["max_turn_rate"];
        };
        QCOMPARE(fastestTurn(1, 0.05).value, 1.0);
        QVERIFY(!fastestTurn(1, 0.05).isAtLeast);
        QCOMPARE(fastestTurn(3, 2).value, 1.0);
        QVERIFY(fastestTurn(3, 2).isAtLeast);
        QCOMPARE(fastestTurn(-3, 0.1).value, 3.0);
        QVERIFY(!fastestTurn(-3, 0.1).isAtLeast);
    }

    void whatIsNoCircleHasNoRadius()
    {
        std::vector<Eigen::Vector2d> line, arc, square;
        for (int i = 0; i < 40; ++i) {
            line.emplace_back(0.02 * i, 0.01 * i);
            arc.emplace_back(std::cos(0.02 * i), std::sin(0.02 * i)); // 45°
            const double u = i % 10 / 10.0;
            square.emplace_back(i < 10   ? u
                                : i < 20 ? 1
                                : i < 30 ? 1 - u
                                         : 0,
                                i < 10   ? 0
                                : i < 20 ? u
                                : i < 30 ? 1
                                         : 1 - u);
        }
        QVERIFY(!fitCircle(line));
        QVERIFY(!fitCircle(arc));
        QVERIFY(!fitCircle(square));
        QVERIFY(!fitCircle({}));
        QVERIFY(!fitCircle(std::vector<Eigen::Vector2d>(20, {1, 1})));
    }
};

ODOGRAPH_TEST(TestMetrics, QCoreApplication)
#include "tst_metrics.moc"
