// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <set>

using namespace odo;

namespace {

SimulatedScene sceneWithClock(double offsetS, double driftPpm)
{
    SimulatedScene scene = demoTestbed(1);
    scene.durationS = 4.0;
    scene.cameras[1].startOffsetS = offsetS;
    scene.cameras[1].clockDriftPpm = driftPpm;
    return scene;
}

} // namespace

class TestScene : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void anEvenClock()
    {
        const SimulatedScene scene = sceneWithClock(0, 0);
        QCOMPARE(frameCount(scene, 0), 120);
        for (const std::int64_t i : {0, 1, 119}) {
            QVERIFY(std::abs(frameSceneTime(scene, 0, i) - static_cast<double>(i) / 30) < 1e-12);
            QCOMPARE(frameStamp(scene, 0, i).count(), std::llround(static_cast<double>(i) * 1e9 / 30));
        }
    }

    void startsLate()
    {
        const SimulatedScene scene = sceneWithClock(0.512, 0);
        QVERIFY(std::abs(frameSceneTime(scene, 1, 0) - 0.512) < 1e-12);
        QCOMPARE(frameStamp(scene, 1, 0).count(), 0);
        // Frames at 0.512 + i/30 < 4: i < 104.64.
        QCOMPARE(frameCount(scene, 1), 105);
        QCOMPARE(frameCount(sceneWithClock(4.5, 0), 1), 0);
    }

    void aFastClockTakesItsFramesSooner()
    {
        const SimulatedScene scene = sceneWithClock(0.01, 500);
        const Nanoseconds stamp = frameStamp(scene, 1, 90);
        QVERIFY(std::abs(toSeconds(stamp) - 3.0) < 1e-9);
        QVERIFY(std::abs(frameSceneTime(scene, 1, 90) - (0.01 + 3.0 / 1.0005)) < 1e-9);
        QVERIFY(std::abs(sceneTimeOfStamp(scene, 1, stamp) - frameSceneTime(scene, 1, 90)) < 1e-9);
    }

    void dropsFrames()
    {
        SimulatedScene scene = sceneWithClock(0.1, 0);
        scene.cameras[1].sensor.droppedFrames = {40, 3, 4, 4, -1, 100000};
        QCOMPARE(frameCount(scene, 1), 117 - 3);
        QVERIFY(std::abs(frameSceneTime(scene, 1, 2) - (0.1 + 2 / 30.0)) < 1e-9);
        QVERIFY(std::abs(frameSceneTime(scene, 1, 3) - (0.1 + 5 / 30.0)) < 1e-9);
        QVERIFY(std::abs(toSeconds(frameStamp(scene, 1, 3)) - 5 / 30.0) < 1e-9);
        QVERIFY(std::abs(frameSceneTime(scene, 1, 38) - (0.1 + 41 / 30.0)) < 1e-9);
        // Without the first frame the zero of the stamps is the second.
        scene.cameras[1].sensor.droppedFrames = {0};
        QCOMPARE(frameStamp(scene, 1, 0).count(), 0);
        QVERIFY(std::abs(frameSceneTime(scene, 1, 0) - (0.1 + 1 / 30.0)) < 1e-9);
        QVERIFY(std::abs(sceneTimeOfStamp(scene, 1, Nanoseconds{0}) - (0.1 + 1 / 30.0)) < 1e-9);
    }

    void anUnevenClockSaysSo()
    {
        SimulatedScene scene = sceneWithClock(0.1, 200);
        scene.cameras[1].jitterS = 0.005;
        double most = 0;
        for (std::int64_t i = 0; i < frameCount(scene, 1); ++i) {
            const Nanoseconds stamp = frameStamp(scene, 1, i);
            most = std::max(most, std::abs(toSeconds(stamp) - static_cast<double>(i) / 30));
            // The stamp is that of the moment at which the picture was taken.
            QVERIFY(std::abs(sceneTimeOfStamp(scene, 1, stamp) - frameSceneTime(scene, 1, i)) < 1e-9);
        }
        QVERIFY(most > 0.004 &&
                most <= 0.005); // of 117 uniform draws one is beyond 4 ms, but for 1 in 10^11 scenes
        QCOMPARE(frameStamp(scene, 1, 0).count(), 0);
    }

    void doublesFrames()
    {
        SimulatedScene scene = sceneWithClock(0, 0);
        scene.cameras[0].sensor.doubledFrames = {10, 20, 21};
        QCOMPARE(frameCount(scene, 0), 120);
        QCOMPARE(sourceFrame(scene, 0, 10), 9);
        QVERIFY(frameSceneTime(scene, 0, 10) == frameSceneTime(scene, 0, 9));
        QVERIFY(frameStamp(scene, 0, 10) > frameStamp(scene, 0, 9));
        QCOMPARE(sourceFrame(scene, 0, 21), 19);
        QCOMPARE(sourceFrame(scene, 0, 22), 22);
    }

    void theDemoIsWhatItPromises()
    {
        const std::vector<DemoTrial> trials = demoTrials();
        std::set<std::string> teams;
        double topSpeed = 0;
        bool hasReflections = false;
        int ofParts = 0;
        for (const DemoTrial &trial : trials) {
            const SimulatedScene &scene = trial.scene;
            teams.insert(trial.team);
            hasReflections = hasReflections || !scene.reflections.empty();
            ofParts += !scene.robots.front().parts.empty();
            QVERIFY(scene.durationS >= 6 && scene.durationS <= 10);
            QCOMPARE(scene.robots.front().name, trial.robot);
            for (double t = 0; t <= scene.durationS; t += 0.02) {
                const MotionState state = scene.robots.front().motion->at(t);
                topSpeed = std::max(topSpeed, state.velocity.norm());
                QVERIFY((state.position.array() > 0.2).all() && state.position.x() < 2.8 &&
                        state.position.y() < 2.0);
            }
        }
        QVERIFY(trials.size() >= 5);
        QCOMPARE(teams.size(), 4u);
        QCOMPARE(ofParts, 1);
        QVERIFY(hasReflections);
        QVERIFY(topSpeed > 1.5 && topSpeed < 2.5);
    }

    void bothDemoCamerasSeeTheWholeFloor()
    {
        const SimulatedScene scene = demoTestbed(1);
        for (const SimulatedCamera &camera : scene.cameras) {
            for (const Marker &marker : scene.floor.markers.markers) {
                // All of the tag and its rim, with 5 px to spare.
                const double half = scene.floor.markerSideM * 0.7;
                for (const Eigen::Vector2d &corner :
                     {Eigen::Vector2d(half, half), Eigen::Vector2d(half, -half), Eigen::Vector2d(-half, half),
                      Eigen::Vector2d(-half, -half)}) {
                    const Eigen::Vector2d point = marker.pointInWorld + corner;
                    const auto pixel = camera.view.pixelFromWorld({point.x(), point.y(), 0});
                    QVERIFY(pixel && pixel->x() > 5 && pixel->y() > 5 && pixel->x() < 1274 &&
                            pixel->y() < 714);
                }
            }
        }
    }
};

ODOGRAPH_TEST(TestScene, QCoreApplication)
#include "tst_scene.moc"
