// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/live/live_scene_setup.h"

#include "core/simulation/demo_testbed.h"
#include "tests/acceptance/scenes/look_robots.h"

#include <numbers>

namespace odo::test {

namespace {

constexpr double roundS = 2, radiusM = 0.45, rampS = 0.5;
constexpr int usualWidthPx = 1280;

/// The same camera with more pixels.
FloorView enlarged(const FloorView &view, double factor)
{
    Intrinsics lens = view.camera().intrinsics();
    lens.widthPx = static_cast<int>(std::lround(factor * lens.widthPx));
    lens.heightPx = static_cast<int>(std::lround(factor * lens.heightPx));
    lens.fxPx *= factor;
    lens.fyPx *= factor;
    lens.cxPx = factor * (lens.cxPx + 0.5) - 0.5; // (0, 0) is the middle of a pixel
    lens.cyPx = factor * (lens.cyPx + 0.5) - 0.5;
    return {*CameraModel::create(lens), view.worldFromCamera(), view.poseCovariance()};
}

} // namespace

LiveScene liveScene(int widthPx, double framesPerSecond, LiveRobot look)
{
    LiveScene live{demoTestbed(3), static_cast<std::int64_t>(framesPerSecond)};
    const auto motion = makeCircleMotion({1.5, 1.1}, radiusM, 2 * std::numbers::pi * radiusM / roundS, rampS);
    SimulatedRobot disc;
    disc.name = "red";
    disc.colour = {0xd7, 0x23, 0x28};
    disc.motion = motion;
    live.scene.robots = {look == LiveRobot::Coloured ? disc : robotOfLook(Look::Rover, motion)};
    live.scene.durationS = static_cast<double>(live.firstFrame) / framesPerSecond + roundS;
    for (SimulatedCamera &camera : live.scene.cameras) {
        camera.framesPerSecond = framesPerSecond;
        camera.clockDriftPpm = 0;
        camera.startOffsetS = 0;
        camera.sensor.exposureS = 0.005;
        camera.view = enlarged(camera.view, static_cast<double>(widthPx) / usualWidthPx);
    }
    return live;
}

} // namespace odo::test
