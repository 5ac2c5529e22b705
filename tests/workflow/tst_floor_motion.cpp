// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/floor_motion.h"

#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/workflow/record/run_control.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace std::chrono_literals;

namespace {

constexpr Nanoseconds zero = 5h; ///< the clock's time at the scene's beginning

/// The demo's testbed, whose robot rests, drives two metres in two seconds, and rests.
SimulatedScene drivenLine(double startS, double durationS)
{
    SimulatedScene scene = demoTestbed(7);
    scene.robots = {
        demoRobot("Blue 1", {.colour = demoBlue}, makeLineMotion({0.5, 0.6}, {2.5, 1.4}, startS, 2.0))};
    scene.durationS = durationS;
    return scene;
}

/// What both cameras see of the floor, in order of time.
std::vector<MotionSight> sightsOf(const SimulatedScene &scene, std::size_t cameras = 2)
{
    std::vector<MotionSight> sights;
    for (std::size_t v = 0; v < cameras; ++v) {
        SceneRenderer renderer(scene, static_cast<int>(v));
        FloorMotion motion(scene.cameras[v].view, watchedArea(scene.floor.markers));
        for (std::int64_t frame = 0; frame < renderer.frameCount(); ++frame) {
            const Nanoseconds taken = zero + fromSeconds(frameSceneTime(scene, static_cast<int>(v), frame));
            if (const auto sight = motion.add(renderer.render(frame), taken))
                sights.push_back(*sight);
        }
    }
    std::ranges::stable_sort(sights, {}, &MotionSight::time);
    return sights;
}

struct Run
{
    std::optional<double> startS, endS; ///< in the scene's time; endS: when it was decided
};

Run runOf(const std::vector<MotionSight> &sights)
{
    Nanoseconds now = zero;
    RunControl control([&now] { return now; });
    RunSettings settings;
    settings.start = RunTrigger{RunTrigger::Kind::Motion};
    settings.stop = RunTrigger{RunTrigger::Kind::Motion, {}, usualRest};
    control.prepare(settings, std::nullopt, 0);
    control.press();
    Run run;
    for (const MotionSight &sight : sights) {
        now = sight.time;
        const auto order = control.floorAt(sight);
        if (order && order->kind == RunOrder::Kind::Begin)
            run.startS = toSeconds(order->at - zero);
        else if (order)
            run.endS = toSeconds(now - zero);
    }
    return run;
}

} // namespace

class TestFloorMotion : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void startsAndEndsWithTheRobot();
    void anEmptyFloorStartsNothing();
    void theLightStartsNothing();
    void whatIsBesideTheFloorStartsNothing();
    void withoutFloorOrSizeNothingIsKnown();
};

/// The run drives from 1.5 s to 3.5 s. A quintic ramp has covered 2 mm, a pixel, a tenth of a second after it
/// begins.
void TestFloorMotion::startsAndEndsWithTheRobot()
{
    const Run run = runOf(sightsOf(drivenLine(1.5, 6)));
    QVERIFY(run.startS && run.endS);
    qInfo("started %.3f s after the robot, ended %.3f s after it", *run.startS - 1.5, *run.endS - 3.5);
    QVERIFY(std::abs(*run.startS - 1.5) < 0.2);
    QVERIFY(*run.endS - 3.5 > 1.2 && *run.endS - 3.5 < 1.8);
}

/// Twenty seconds of twice the usual noise, under lamps that flicker, before a camera whose gain drifts.
void TestFloorMotion::anEmptyFloorStartsNothing()
{
    SimulatedScene scene = demoTestbed(8);
    scene.durationS = 20;
    for (SimulatedCamera &camera : scene.cameras) {
        camera.sensor.noiseSigma = 4;
        camera.sensor.flickerAmplitude = 0.03;
        camera.sensor.gainDriftPerS = 0.005;
    }
    const std::vector<MotionSight> sights = sightsOf(scene, 1);
    QVERIFY(sights.size() > 590);
    const auto moving = std::ranges::count(sights, true, &MotionSight::moves);
    QCOMPARE(moving, 0);
    QVERIFY(!runOf(sights).startS);
}

/// A flash of a single frame, and a lamp that is switched on.
void TestFloorMotion::theLightStartsNothing()
{
    SimulatedScene scene = demoTestbed(9);
    scene.durationS = 3;
    scene.lights = {{1.4, 1.0, 0.034}, {0.7, 2.0, 100}};
    QVERIFY(!runOf(sightsOf(scene, 1)).startS);
    // A glitch of a single frame, of a part of the floor.
    scene.lights.clear();
    scene.reflections = {{demoRed, {1.5, 1.1}, 0.2, 1.0, 0.034, -1}};
    QVERIFY(!runOf(sightsOf(scene, 1)).startS);
}

/// Somebody walks past.
void TestFloorMotion::whatIsBesideTheFloorStartsNothing()
{
    SimulatedScene scene = drivenLine(1, 4);
    FloorArea elsewhere(Eigen::Vector2d(0.3, 1.7), Eigen::Vector2d(2.7, 2.2));
    SceneRenderer renderer(scene, 0);
    FloorMotion motion(scene.cameras[0].view, elsewhere);
    int moving = 0, seen = 0;
    for (std::int64_t frame = 0; frame < 60; ++frame) { // while it is far from there
        const auto sight = motion.add(renderer.render(frame), zero + frame * 33333333ns);
        seen += sight ? 1 : 0;
        moving += sight && sight->moves ? 1 : 0;
    }
    QVERIFY(seen > 50);
    QCOMPARE(moving, 0);
}

void TestFloorMotion::withoutFloorOrSizeNothingIsKnown()
{
    const SimulatedScene scene = drivenLine(0, 1);
    FloorMotion nowhere(scene.cameras[0].view, watchedArea({}));
    QCOMPARE(nowhere.cellCount(), std::size_t(0));
    FloorMotion motion(scene.cameras[0].view, watchedArea(scene.floor.markers));
    QVERIFY(motion.cellCount() > 1000);
    const Frame small = FrameBuffer::toFrame(std::make_shared<FrameBuffer>(FrameFormat{640, 360}), 0, 0ns);
    SceneRenderer renderer(scene, 0);
    for (std::int64_t frame = 0; frame < 10; ++frame) {
        QVERIFY(!nowhere.add(renderer.render(frame), frame * 33ms));
        QVERIFY(!motion.add(small, frame * 33ms));
    }
}

ODOGRAPH_TEST(TestFloorMotion, QCoreApplication)
#include "tst_floor_motion.moc"
