// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/scene_catalogue.h"

#include "tests/acceptance/scenes/drawn_motions.h"
#include "tests/acceptance/scenes/drawn_testbed.h"
#include "tests/acceptance/scenes/hard_scenes.h"
#include "tests/acceptance/scenes/look_scenes.h"
#include "tests/acceptance/scenes/scene_robots.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <iterator>
#include <utility>

namespace odo::test {

namespace {

AccuracyScene withRobot(SeededDraw &draw, const Corners &corners, double durationS,
                        const SimulatedRobot &robot, bool hasGivenSize = true)
{
    AccuracyScene scene;
    scene.scene = drawnTestbed(draw, corners);
    scene.scene.durationS = durationS;
    addRobot(scene, draw, robot, hasGivenSize);
    return scene;
}

AccuracyScene straight(SeededDraw &draw)
{
    return withRobot(draw, nearSide, 6, boxRobot("red", red, drawnLine(draw, draw.between(3.0, 4.0))));
}

AccuracyScene circle(SeededDraw &draw)
{
    return withRobot(draw, nearSide, 8, boxRobot("blue", blue, drawnCircle(draw)));
}

AccuracyScene figureEight(SeededDraw &draw)
{
    return withRobot(draw, across, 8,
                     boxRobot("green", green, drawnFigureEight(draw, draw.between(1.2, 1.6))));
}

AccuracyScene stopAndGo(SeededDraw &draw)
{
    return withRobot(draw, nearSide, 8, boxRobot("red", red, drawnStopAndGo(draw)));
}

AccuracyScene wander(SeededDraw &draw)
{
    return withRobot(draw, across, 8, boxRobot("blue", blue, drawnWander(draw, 9, 0.9)));
}

AccuracyScene slowCrawl(SeededDraw &draw)
{
    return withRobot(draw, nearSide, 8, boxRobot("magenta", magenta, drawnCrawl(draw, 8)));
}

AccuracyScene fast(SeededDraw &draw)
{
    AccuracyScene scene =
        withRobot(draw, nearSide, 7, boxRobot("red", red, drawnFigureEight(draw, draw.between(1.9, 2.1))));
    scene.recording.codec = VideoCodec::Mjpeg;
    return scene;
}

AccuracyScene cylinder(SeededDraw &draw)
{
    SimulatedRobot robot = boxRobot("green", green, drawnWander(draw, 9, 0.9));
    robot.shape = SimulatedShape::Cylinder;
    robot.lengthM = robot.widthM = 0.22;
    robot.heightM = 0.09;
    return withRobot(draw, nearSide, 8, robot);
}

AccuracyScene tall(SeededDraw &draw)
{
    SimulatedRobot robot = boxRobot("red", red, drawnFigureEight(draw, draw.between(1.0, 1.4)));
    robot.lengthM = 0.18;
    robot.widthM = 0.15;
    robot.heightM = 0.12;
    return withRobot(draw, nearSide, 8, robot);
}

AccuracyScene threeCameras(SeededDraw &draw)
{
    return withRobot(draw, {Corner::NearLeft, Corner::NearRight, Corner::FarLeft}, 7,
                     boxRobot("red", red, drawnWander(draw, 8, 0.9)));
}

AccuracyScene oneCamera(SeededDraw &draw)
{
    AccuracyScene scene = withRobot(draw, {Corner::NearLeft}, 7,
                                    boxRobot("blue", blue, drawnFigureEight(draw, draw.between(1.0, 1.4))));
    scene.oneView = true;
    scene.recording.codec = VideoCodec::Mjpeg;
    return scene;
}

AccuracyScene notGiven(SeededDraw &draw)
{
    return withRobot(draw, nearSide, 8, boxRobot("red", red, drawnFigureEight(draw, draw.between(1.0, 1.4))),
                     false);
}

AccuracyScene notGivenTall(SeededDraw &draw)
{
    SimulatedRobot robot = boxRobot("green", green, drawnWander(draw, 9, 0.9));
    robot.lengthM = 0.2;
    robot.widthM = 0.16;
    robot.heightM = 0.11;
    return withRobot(draw, across, 8, robot, false);
}

AccuracyScene light(SeededDraw &draw)
{
    constexpr double durationS = 8;
    AccuracyScene scene = withRobot(draw, nearSide, durationS, boxRobot("blue", blue, drawnCircle(draw)));
    const double sign = draw.sign();
    for (SimulatedCamera &camera : scene.scene.cameras) {
        // From the usual light to 35 % more or less at the end, with the beat of lamps on top.
        camera.sensor.gainDriftPerS = (camera.name == "A" ? sign : -sign) * 0.35 / durationS;
        camera.sensor.flickerAmplitude = 0.04;
    }
    scene.recording.codec = VideoCodec::Mjpeg;
    return scene;
}

AccuracyScene centreChroma(SeededDraw &draw)
{
    AccuracyScene scene =
        withRobot(draw, nearSide, 8, boxRobot("red", red, drawnFigureEight(draw, draw.between(1.0, 1.4))));
    for (SimulatedCamera &camera : scene.scene.cameras)
        camera.sensor.siting = ChromaSiting::Center;
    return scene;
}

AccuracyScene irregularFrames(SeededDraw &draw)
{
    AccuracyScene scene = withRobot(draw, nearSide, 8, boxRobot("green", green, drawnWander(draw, 9, 0.9)));
    for (SimulatedCamera &camera : scene.scene.cameras) {
        camera.jitterS = 0.004;
        for (int i = 0; i < 6; ++i) {
            camera.sensor.droppedFrames.push_back(draw.whole(10, 220));
            camera.sensor.doubledFrames.push_back(draw.whole(10, 220));
        }
    }
    return scene;
}

AccuracyScene offsetWander(SeededDraw &draw)
{
    AccuracyScene scene = withRobot(draw, across, 9, boxRobot("red", red, drawnWander(draw, 10, 0.9)));
    scene.scene.cameras[1].startOffsetS += draw.between(0.1, 0.9);
    scene.findsOffset = true;
    return scene;
}

AccuracyScene offsetStopAndGo(SeededDraw &draw)
{
    AccuracyScene scene = withRobot(draw, nearSide, 9, boxRobot("blue", blue, drawnStopAndGo(draw)));
    scene.findsOffset = true;
    return scene;
}

using Maker = AccuracyScene (*)(SeededDraw &);

const std::vector<std::pair<std::string, Maker>> &plainScenes()
{
    static const std::vector<std::pair<std::string, Maker>> scenes{{"straight", straight},
                                                                   {"circle", circle},
                                                                   {"figure-eight", figureEight},
                                                                   {"stop-and-go", stopAndGo},
                                                                   {"wander", wander},
                                                                   {"slow-crawl", slowCrawl},
                                                                   {"fast", fast},
                                                                   {"cylinder", cylinder},
                                                                   {"tall", tall},
                                                                   {"three-cameras", threeCameras},
                                                                   {"one-camera", oneCamera},
                                                                   {"not-told", notGiven},
                                                                   {"not-told-tall", notGivenTall},
                                                                   {"light", light},
                                                                   {"centre-chroma", centreChroma},
                                                                   {"irregular-frames", irregularFrames},
                                                                   {"offset-wander", offsetWander},
                                                                   {"offset-stop-and-go", offsetStopAndGo}};
    return scenes;
}

constexpr SceneKind allKinds[] = {SceneKind::Plain, SceneKind::Hard, SceneKind::Look};

const std::vector<std::pair<std::string, Maker>> &scenesOf(SceneKind kind)
{
    return kind == SceneKind::Plain ? plainScenes() : kind == SceneKind::Hard ? hardScenes() : lookScenes();
}

} // namespace

std::vector<std::string> sceneNames(SceneKind kind)
{
    std::vector<std::string> names;
    for (const auto &[name, maker] : scenesOf(kind))
        names.push_back(name);
    return names;
}

std::vector<std::string> allSceneNames()
{
    std::vector<std::string> names;
    for (const SceneKind kind : allKinds)
        std::ranges::move(sceneNames(kind), std::back_inserter(names));
    return names;
}

AccuracyScene makeScene(const std::string &name, unsigned seed)
{
    SeededDraw draw(name, seed);
    for (const SceneKind kind : allKinds) {
        for (const auto &[known, maker] : scenesOf(kind)) {
            if (known != name)
                continue;
            AccuracyScene scene = maker(draw);
            scene.kind = kind;
            scene.name = name;
            scene.seed = seed;
            return scene;
        }
    }
    assert(false);
    return {};
}

} // namespace odo::test
