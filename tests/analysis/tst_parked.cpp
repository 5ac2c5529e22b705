// SPDX-License-Identifier: GPL-3.0-or-later
// A robot that is parked on a gate's line or on a zone's edge passes it once, and drives no lap by standing.
#include "core/analysis/gate_passages.h"
#include "core/analysis/task_metrics.h"
#include "core/trajectory/imported_track.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>
#include <algorithm>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int runs = 50;
constexpr double parkedS = 10;

/// Noise of 0.3 to 3 mm over the runs.
double noiseOf(int run)
{
    return 0.0003 * std::pow(10, double(run) / (runs - 1));
}

/// How far a robot is that drives at 0.5 m/s, is parked when it has come so far, and drives on.
double distanceAt(double timeS, double parkedAtM)
{
    constexpr double speed = 0.5, accel = 1, braking = speed * speed / (2 * accel), rampS = speed / accel;
    const auto starting = [](double t) {
        return t < 0 ? 0 : t < rampS ? accel * t * t / 2 : braking + speed * (t - rampS);
    };
    const double arrivedS = rampS + (parkedAtM - braking) / speed + rampS / 2;
    const double until = parkedAtM - starting(arrivedS - timeS);
    if (timeS < arrivedS)
        return std::min(starting(timeS), until);
    return parkedAtM + starting(timeS - arrivedS - parkedS);
}

Profile analysed(const Course &course, double durationS, double noiseM, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, noiseM);
    std::vector<ImportedPosition> track;
    for (int i = 0; i < durationS * 30; ++i) {
        ImportedPosition row;
        row.time = fromSeconds(i / 30.0);
        row.position = course(i / 30.0).position + Eigen::Vector2d(noise(random), noise(random));
        track.push_back(row);
    }
    const auto raw = samplesOfImported(track, estimateImportedNoiseM(track));
    return analyseImported(raw, optionsForImported({}, raw)).value();
}

double metricOf(const std::vector<Metric> &metrics, const char *name)
{
    const auto found = std::ranges::find(metrics, std::string(name), &Metric::name);
    return found == metrics.end() ? -1 : found->value;
}

} // namespace

class TestParked : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void onAGateAndAZonesEdgeItIsCountedOnce()
    {
        // Along +x: parked at 0, where a gate is and where a zone to keep out of begins.
        Task task;
        task.gates = {gateAcross("gate", GateRole::Split, {0, 0}, {1, 0}, 0.6)};
        task.zones = {{"out", ZoneRule::StayOutside, {{0, -0.5}, {2, -0.5}, {2, 0.5}, {0, 0.5}}},
                      {"in", ZoneRule::StayInside, {{-2, -0.5}, {0, -0.5}, {0, 0.5}, {-2, 0.5}}}};
        for (int run = 0; run < runs; ++run) {
            const Profile profile = analysed(
                [](double t) {
                    return Truth{{distanceAt(t, 0.8) - 0.8, 0.02}, {}, {}};
                },
                14, noiseOf(run), unsigned(run));
            const TaskMetrics measured = measureTask(task, profile.samples, profile.points);
            QVERIFY2(
                measured.passages.size() == 1,
                qPrintable(QStringLiteral("run %1: %2 passages").arg(run).arg(measured.passages.size())));
            QVERIFY2(metricOf(measured.metrics, "zone_breaches") == 2,
                     qPrintable(QStringLiteral("run %1: %2 breaches")
                                    .arg(run)
                                    .arg(metricOf(measured.metrics, "zone_breaches"))));
        }
    }
    /// It comes to the line and drives back.
    void whoTurnsBackOnTheLineHasNotPassedIt()
    {
        Task task;
        task.gates = {gateAcross("gate", GateRole::StartFinish, {0, 0}, {1, 0}, 0.6)};
        for (int run = 0; run < runs; ++run) {
            const Profile profile = analysed(
                [](double t) {
                    const double distance = distanceAt(t, 0.8);
                    return Truth{{distance < 0.8 ? distance - 0.8 : 0.8 - distance, 0}, {}, {}};
                },
                14, noiseOf(run), unsigned(run));
            const TaskMetrics measured = measureTask(task, profile.samples, profile.points);
            QVERIFY2(measured.passages.empty() && metricOf(measured.metrics, "laps") == 0,
                     qPrintable(QString::number(run)));
        }
    }
    void noLapThatWasNotDriven()
    {
        // Two laps around a circle, parked on the line between them.
        constexpr double radiusM = 0.4, around = 2 * M_PI * radiusM;
        Task task;
        task.gates = {gateAcross("line", GateRole::StartFinish, {radiusM, 0}, {0, 1}, 0.4)};
        const Course course = [=](double t) {
            const double first = distanceAt(t, 0.3 + around);
            const double angle = (first - 0.3) / radiusM;
            return Truth{radiusM * Eigen::Vector2d(std::cos(angle), std::sin(angle)), {}, {}};
        };
        for (int run = 0; run < runs; ++run) {
            const Profile profile = analysed(course, 23, noiseOf(run), unsigned(run));
            const TaskMetrics measured = measureTask(task, profile.samples, profile.points);
            QVERIFY2(measured.passages.size() == 3 && metricOf(measured.metrics, "laps") == 2,
                     qPrintable(QStringLiteral("run %1: %2 passages, %3 laps")
                                    .arg(run)
                                    .arg(measured.passages.size())
                                    .arg(metricOf(measured.metrics, "laps"))));
        }
    }
};

ODOGRAPH_TEST(TestParked, QCoreApplication)
#include "tst_parked.moc"
