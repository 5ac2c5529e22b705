// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/live_tracking.h"

#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <atomic>
#include <future>
#include <set>

using namespace odo;
using namespace std::chrono_literals;

namespace {

/// One of the demo's trials as live cameras give it, as fast as it is tracked.
struct Drive
{
    explicit Drive(const std::string &trial)
    {
        for (const DemoTrial &each : demoTrials()) {
            if (each.trial == trial)
                scene = each.scene;
        }
        for (const SimulatedCamera &camera : scene.cameras) {
            views.push_back({camera.name, camera.view});
            feeds.push_back(std::make_shared<BoundedQueue<TimedFrame>>(1));
        }
        RobotRecord robot;
        robot.name = scene.robots.front().name;
        robot.colour = scene.robots.front().colour;
        robot.heightMode = RobotRecord::Height::Given;
        robot.heightM = scene.robots.front().heightM;
        robots.push_back(robot);
    }

    Result<std::unique_ptr<LiveTracker>> follow()
    {
        return LiveTracker::create(views, robots, feeds,
                                   {[this](const LiveSight &sight) { ++sights[sight.view]; },
                                    [this](const LiveMoment &moment) {
                                        moments.push_back(moment);
                                        ++momentCount;
                                    }});
    }
    /// Each picture in its turn; none is dropped. stalls: a view that gives nothing in this part of the
    /// scene.
    void play(double fromS, double toS, std::optional<std::size_t> silent = std::nullopt)
    {
        std::vector<std::unique_ptr<SceneRenderer>> renderers;
        for (std::size_t v = 0; v < views.size(); ++v)
            renderers.push_back(std::make_unique<SceneRenderer>(scene, static_cast<int>(v)));
        for (std::int64_t frame = 0; frame < renderers.front()->frameCount(); ++frame) {
            for (std::size_t v = 0; v < views.size(); ++v) {
                const double timeS = frameSceneTime(scene, static_cast<int>(v), frame);
                if (timeS < fromS || timeS >= toS || silent == v)
                    continue;
                TimedFrame timedFrame;
                timedFrame.captured.frame = renderers[v]->render(frame);
                timedFrame.taken = zero + fromSeconds(timeS);
                feeds[v]->push(std::move(timedFrame));
            }
        }
    }
    /// Root mean square against the truth, and how many there were.
    std::pair<double, int> positionRms() const
    {
        double sum = 0;
        int count = 0;
        for (const LiveMoment &moment : moments) {
            if (!moment.position.point.valid)
                continue;
            const MotionState truth =
                scene.robots.front().motion->at(toSeconds(moment.position.sample.time - zero));
            sum += (moment.position.point.position - truth.position).squaredNorm();
            ++count;
        }
        return {std::sqrt(sum / std::max(1, count)), count};
    }

    SimulatedScene scene;
    std::vector<LiveView> views;
    std::vector<RobotRecord> robots;
    std::vector<LiveTracker::Feed> feeds;
    std::map<std::size_t, int> sights;
    std::vector<LiveMoment> moments; ///< to be read when the tracker has ended
    std::atomic<std::size_t> momentCount = 0;
    const Nanoseconds zero = 5h; ///< the steady clock's time at the scene's beginning
};

} // namespace

class TestLiveTracking : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void placesAreTrueAndTheRunIsAnalysedAsARecordingIs();
    void oneCameraUnregisteredOrOfAnotherSize();
    void aViewThatStalls();
    void noRobotSeenAndNoneKnown();
    void aRobotOfAnyLookIsFoundOnceItHasMoved();
    void whatIsTooFastIsDroppedAndCounted();
    void saysHowFarBehindTheMapIs();
};

void TestLiveTracking::placesAreTrueAndTheRunIsAnalysedAsARecordingIs()
{
    Drive drive("circle");
    auto live = drive.follow();
    QVERIFY(live);
    (*live)->beginRun(drive.zero + 500ms);
    drive.play(0, 8);
    const std::vector<LiveRun> runs = (*live)->endRun();
    live->reset(); // all that was given is tracked
    const auto [rms, count] = drive.positionRms();
    QVERIFY2(count > 225, qPrintable(QString::number(count))); // of 240, the first tell no speed yet
    // docs/accuracy.md has 1 mm for recordings; the silhouette's centre in place of the solid costs some
    // millimetres.
    QVERIFY2(rms < 0.006, qPrintable(QString::number(rms)));

    QCOMPARE(runs.size(), std::size_t(1));
    QVERIFY(runs.front().views.front().observations.front().time >= 0s);
    const auto analysis = analyseRun(runs.front(), {}, std::nullopt);
    QVERIFY(analysis);
    const auto top = std::ranges::find(analysis->profile.metrics, std::string("max_speed"), &Metric::name);
    QVERIFY(top != analysis->profile.metrics.end());
    QVERIFY2(std::abs(top->value - 1.1) < 3 * top->sigma.value_or(0) + 0.01,
             qPrintable(QString::number(top->value)));
}

void TestLiveTracking::oneCameraUnregisteredOrOfAnotherSize()
{
    Drive drive("circle");
    drive.views[0].floorView.reset();
    const SimulatedCamera &b = drive.scene.cameras[1];
    {
        auto live = drive.follow();
        drive.play(0, 3);
        live->reset();
        const auto [rms, count] = drive.positionRms();
        QVERIFY2(count > 70 && rms < 0.015, qPrintable(QString::number(rms)));
        QCOMPARE(drive.sights[0], 90); // it is shown all the same
    }
    Drive other("circle");
    Intrinsics lens = b.view.camera().intrinsics();
    lens.widthPx = 640;
    other.views[0].floorView.reset();
    other.views[1].floorView =
        FloorView(*CameraModel::create(lens), b.view.worldFromCamera(), b.view.poseCovariance());
    auto live = other.follow();
    (*live)->beginRun(other.zero);
    other.play(0, 0.5);
    const auto runs = (*live)->endRun();
    live->reset();
    QVERIFY(other.moments.empty());
    QCOMPARE(analyseRun(runs.front(), {}, std::nullopt).error().code, ErrorCode::Undetermined);
}

void TestLiveTracking::aViewThatStalls()
{
    for (const std::size_t silent : {std::size_t(0), std::size_t(1)}) {
        Drive drive("circle");
        auto live = drive.follow();
        drive.play(0, 1);
        const std::size_t before = drive.momentCount;
        drive.play(1, 3, silent);
        live->reset();
        QVERIFY(drive.moments.size() >
                before + 45); // of 60, less the fifth of a second that it is waited for
        QCOMPARE(drive.moments.back().position.sample.views, silent == 0 ? 2u : 1u);
        const double rms = drive.positionRms().first;
        QVERIFY2(rms < 0.015, qPrintable(QString::number(rms)));
    }
}

void TestLiveTracking::noRobotSeenAndNoneKnown()
{
    Drive drive("circle");
    drive.scene.robots.clear();
    {
        auto live = drive.follow();
        (*live)->beginRun(drive.zero);
        drive.play(0, 0.5);
        const auto runs = (*live)->endRun();
        QCOMPARE((*live)->statistics().latencyMedianS, 0.0);
        live->reset();
        QVERIFY(!drive.moments.empty());
        for (const LiveMoment &moment : drive.moments)
            QVERIFY(!moment.position.sample.position && !moment.position.point.valid);
        QVERIFY(analyseRun(runs.front(), {}, std::nullopt)
                    .error()
                    .why.english()
                    .find("was not found in any frame") != std::string::npos);
    }
    Drive none("circle");
    none.robots.clear();
    auto live = none.follow();
    none.play(0, 0.2);
    live->reset();
    QVERIFY(none.moments.empty());
    QCOMPARE(none.sights[0], 6);
}

void TestLiveTracking::aRobotOfAnyLookIsFoundOnceItHasMoved()
{
    Drive drive("circle");
    drive.robots.front().colour.reset();
    auto live = drive.follow();
    QVERIFY(live);
    drive.play(0, 6);
    live->reset();
    const auto [rms, count] = drive.positionRms();
    // The background is learned while it leaves its own first place, at the latest when half of the run is
    // over; each view learns in its own thread, so that the first place differs by a few frames from run to
    // run.
    QVERIFY2(count >= 90, qPrintable(QString::number(count)));
    QVERIFY2(rms < 0.01, qPrintable(QString::number(rms)));
}

void TestLiveTracking::whatIsTooFastIsDroppedAndCounted()
{
    Drive drive("circle");
    drive.robots.clear();
    std::promise<void> arrived, goOn;
    auto going = goOn.get_future();
    int sights = 0;
    auto live = LiveTracker::create(drive.views, {}, drive.feeds,
                                    {[&](const LiveSight &) {
                                         if (++sights == 1) {
                                             arrived.set_value();
                                             going.wait();
                                         }
                                     },
                                     {}});
    TimedFrame timedFrame;
    timedFrame.captured.frame = SceneRenderer(drive.scene, 0).render(0);
    drive.feeds[0]->pushOrDrop(timedFrame);
    arrived.get_future().wait();
    for (int i = 0; i < 5; ++i) {
        timedFrame.taken += 33ms;
        QVERIFY(drive.feeds[0]->pushOrDrop(timedFrame));
    }
    goOn.set_value();
    QTRY_COMPARE((*live)->statistics().tracked, 2u);
    QCOMPARE((*live)->statistics().dropped, 4u);
}

void TestLiveTracking::saysHowFarBehindTheMapIs()
{
    QCOMPARE(liveWords({}).english(), std::string());
    QCOMPARE(liveWords({60, 0, 0.0384, 0.06}).english(),
             std::string("the map is 38 ms behind, no frame skipped"));
    QCOMPARE(liveWords({60, 12, 0.051, 0.06}).english(),
             std::string("the map is 51 ms behind, 12 frames skipped"));
}

ODOGRAPH_TEST(TestLiveTracking, QCoreApplication)
#include "tst_live_tracking.moc"
