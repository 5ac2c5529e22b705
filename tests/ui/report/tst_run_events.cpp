// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/number_text.h"
#include "ui/report/internal/run_painting.h"
#include "ui/report/trial_report.h"

#include <QTest>

using namespace odo;

namespace {

/// A robot that stands for a second, drives a straight line at 1 m/s for two, and stands again, 20 times a
/// second.
Profile straightRun()
{
    Profile profile;
    for (int i = 0; i <= 80; ++i) {
        const double t = i / 20.0, moving = std::clamp(t - 1, 0.0, 2.0);
        const bool moves = t > 1 && t < 3;
        Sample sample;
        sample.time = fromSeconds(t);
        sample.frame = i;
        sample.position = Eigen::Vector2d(moving, 0);
        sample.covariance = 1e-6 * Eigen::Matrix2d::Identity();
        profile.samples.push_back(sample);
        ProfilePoint point;
        point.position = {moving, 0};
        point.velocity = {moves ? 1.0 : 0.0, 0};
        point.acceleration = {0, 0};
        point.speedMps = moves ? 1.0 : 0.0;
        point.sigmaXM = point.sigmaYM = 0.001;
        point.sigmaSpeedMps = t > 2 && t < 2.02 ? 0.001 : 0.002; // best known in the middle
        point.valid = true;
        profile.points.push_back(point);
    }
    return profile;
}

void addSpikes(Profile &profile, const std::vector<std::int64_t> &at)
{
    for (const std::int64_t index : at)
        profile.spikes.push_back({index, profile.samples[std::size_t(index)].time, flagBit(SampleFlag::Jump),
                                  foreignWords("off by 80 mm")});
}

} // namespace

class TestRunEvents : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void motionAndTopSpeedInTheOrderOfTime()
    {
        const auto events = runEvents(straightRun(), 12);
        QCOMPARE(events.size(), std::size_t(3));
        QCOMPARE(events[0].words, QStringLiteral("Starts to move"));
        QVERIFY(std::abs(toSeconds(events[0].time) - 1) < 0.06);
        QVERIFY(events[1].kind == RunEvent::Kind::TopSpeed);
        QVERIFY(events[1].words.startsWith(QStringLiteral("Top speed, 1.00")));
        QCOMPARE(events[2].words, QStringLiteral("Stops"));
        QVERIFY(std::abs(toSeconds(events[2].time) - 3) < 0.06);
        for (std::size_t i = 0; i < events.size(); ++i)
            QCOMPARE(events[i].number, int(i) + 1);
    }
    void aRunThatIsCutOffIsToldSo()
    {
        Profile profile = straightRun();
        profile.samples.resize(50);
        profile.points.resize(50);
        profile.samples.erase(profile.samples.begin(), profile.samples.begin() + 30);
        profile.points.erase(profile.points.begin(), profile.points.begin() + 30);
        const auto events = runEvents(profile, 12);
        QCOMPARE(events.front().words, QStringLiteral("First seen, moving already"));
        QCOMPARE(events.back().words, QStringLiteral("Last seen, still moving"));
    }
    void whatWasNotMeasuredIsTold()
    {
        Profile profile = straightRun();
        for (std::size_t i = 30; i < 50; ++i)
            profile.points[i].valid = false;
        profile.gaps = {{profile.samples[29].time, profile.samples[50].time}};
        addSpikes(profile, {55, 56, 70});
        const auto events = runEvents(profile, 4);
        const auto gap = std::ranges::find(events, RunEvent::Kind::Gap, &RunEvent::kind);
        QVERIFY(gap != events.end());
        QCOMPARE(gap->words, QStringLiteral("Not measured for ") + secondsText(fromSeconds(1.05)));
        QCOMPARE(gap->until, profile.samples[50].time);
        QCOMPARE(gap->position.x(), profile.points[29].position.x());
        QCOMPARE(std::ranges::count(events, RunEvent::Kind::Spike, &RunEvent::kind), 0);
    }
    void spikesInARowAreOne()
    {
        Profile profile = straightRun();
        addSpikes(profile, {25, 26, 29, 50});
        const auto events = runEvents(profile, 12);
        std::vector<RunEvent> spikes;
        std::ranges::copy_if(events, std::back_inserter(spikes),
                             [](const RunEvent &e) { return e.kind == RunEvent::Kind::Spike; });
        QCOMPARE(spikes.size(), std::size_t(2));
        QVERIFY(spikes[0].words.startsWith(QStringLiteral("Spike: off by 80 mm (3 ")));
        QCOMPARE(spikes[0].until, profile.samples[29].time);
        QCOMPARE(spikes[1].words, QStringLiteral("Spike: off by 80 mm"));
    }
    void whatMattersLeastIsLeftOut()
    {
        Profile profile = straightRun();
        profile.passages = {{"A", GateRole::Start, fromSeconds(1.5), 0, 0},
                            {"B", GateRole::Finish, fromSeconds(2.5), 0, 0}};
        addSpikes(profile, {22, 23, 24, 40, 55});
        const auto events = runEvents(profile, 6);
        QCOMPARE(events.size(), std::size_t(6));
        QCOMPARE(std::ranges::count(events, RunEvent::Kind::Spike, &RunEvent::kind), 1);
        QVERIFY(std::ranges::find(events, RunEvent::Kind::Spike, &RunEvent::kind)
                    ->words.contains(QStringLiteral("(3 ")));
        QVERIFY(std::ranges::is_sorted(events, {}, &RunEvent::time));
        const auto few = runEvents(profile, 4);
        QCOMPARE(std::ranges::count(few, RunEvent::Kind::Motion, &RunEvent::kind), 2);
        QCOMPARE(std::ranges::count(few, RunEvent::Kind::Gate, &RunEvent::kind), 1);
    }
    void nothingHappensInNothing()
    {
        QVERIFY(runEvents({}, 12).empty());
        Profile standing = straightRun();
        standing.samples.resize(15);
        standing.points.resize(15);
        QVERIFY(runEvents(standing, 12).empty());
    }
    void missingFramesAreThoseTheTimesLeaveOut()
    {
        std::vector<Nanoseconds> times;
        for (int i = 0; i < 100; ++i)
            if (i != 10 && i != 50 && i != 51)
                times.push_back(fromSeconds(i / 30.0 + (i % 2 ? 1e-3 : -1e-3)));
        QCOMPARE(missingFrames(times), 3);
        QCOMPARE(missingFrames({}), 0);
        QCOMPARE(missingFrames({Nanoseconds(0), Nanoseconds(1)}), 0);
    }
};

ODOGRAPH_TEST(TestRunEvents, QCoreApplication)
#include "tst_run_events.moc"
