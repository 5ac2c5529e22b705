// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/hard_scenes.h"

#include "tests/acceptance/scenes/drawn_motions.h"
#include "tests/acceptance/scenes/drawn_testbed.h"
#include "tests/acceptance/scenes/scene_robots.h"

#include <cmath>
#include <numbers>

namespace odo::test {

namespace {

using std::numbers::pi;

AccuracyScene emptyScene(SeededDraw &draw, double durationS)
{
    AccuracyScene scene;
    scene.scene = drawnTestbed(draw, {Corner::NearLeft, Corner::NearRight});
    scene.scene.durationS = durationS;
    return scene;
}

Eigen::Vector2d acrossHeading(const MotionState &state)
{
    return {-std::sin(state.headingRad), std::cos(state.headingRad)};
}

/// A reflection of the robot's own colour, its edge at a gap (negative: touching) from the robot's side.
Reflection besideRobot(SeededDraw &draw, const SimulatedRobot &robot, double startS, double gapM, int camera)
{
    const double durationS = draw.between(0.07, 0.25), radiusM = draw.between(0.06, 0.12);
    const MotionState state = robot.motion->at(startS + durationS / 2);
    const double away = robot.widthM / 2 + radiusM + gapM;
    return {robot.colour, state.position + draw.sign() * away * acrossHeading(state),
            radiusM,      startS,
            durationS,    camera};
}

/// One far from the robot, on the floor.
Reflection farFromRobot(SeededDraw &draw, const SimulatedRobot &robot, double startS, int camera)
{
    const double durationS = draw.between(0.07, 0.4), radiusM = draw.between(0.06, 0.13);
    for (;;) {
        const Eigen::Vector2d place(draw.between(0.2, 2.8), draw.between(0.2, 2.0));
        if ((place - robot.motion->at(startS).position).norm() > 0.8)
            return {robot.colour, place, radiusM, startS, durationS, camera};
    }
}

AccuracyScene reflections(SeededDraw &draw)
{
    AccuracyScene scene = emptyScene(draw, 9);
    const SimulatedRobot robot = boxRobot("blue", blue, drawnFigureEight(draw, draw.between(1.1, 1.4)));
    addRobot(scene, draw, robot);
    int camera = draw.whole(0, 1);
    for (double t = 1.8; t < 8.4; t += draw.between(0.6, 0.8)) {
        const int kind = draw.whole(0, 2);
        scene.scene.reflections.push_back(
            kind == 0   ? farFromRobot(draw, robot, t, camera)
            : kind == 1 ? besideRobot(draw, robot, t, draw.between(0.03, 0.08), camera)
                        : besideRobot(draw, robot, t, draw.between(-0.05, 0.0), camera));
        camera = 1 - camera;
    }
    return scene;
}

/// Large ones that touch the robot: what pulls a centre away the most. Some are seen by both cameras.
AccuracyScene touchingReflections(SeededDraw &draw)
{
    AccuracyScene scene = emptyScene(draw, 9);
    const SimulatedRobot robot = boxRobot("red", red, drawnWander(draw, 10, 0.9));
    addRobot(scene, draw, robot);
    for (double t = 1.5; t < 7.5; t += draw.between(0.6, 0.8)) {
        Reflection reflection = besideRobot(draw, robot, t, draw.between(-0.05, -0.02), draw.whole(-1, 1));
        reflection.radiusM = draw.between(0.1, 0.15);
        scene.scene.reflections.push_back(reflection);
    }
    return scene;
}

AccuracyScene decoys(SeededDraw &draw)
{
    AccuracyScene scene = emptyScene(draw, 8);
    const Eigen::Vector2d centre(draw.between(1.4, 1.6), draw.between(1.05, 1.15));
    const double radius = draw.between(0.6, 0.7);
    const SimulatedRobot robot = boxRobot(
        "red", red,
        makeEllipseMotion(centre, radius, radius, draw.between(3.8, 4.6), draw.between(0, 2 * pi), 1.2));
    addRobot(scene, draw, robot);
    // Tape in the circle's middle and, a hand's breadth beside the way, along it.
    const double outer = radius + 0.22;
    for (const Eigen::Vector2d &middle : {centre, Eigen::Vector2d(centre.x() + outer, centre.y())})
        scene.scene.floor.patches.push_back(
            {robot.colour,
             {middle + Eigen::Vector2d(-0.025, -0.18), middle + Eigen::Vector2d(0.025, -0.18),
              middle + Eigen::Vector2d(0.025, 0.18), middle + Eigen::Vector2d(-0.025, 0.18)}});
    // Someone in a shirt of that colour comes to the far end and stays a while.
    scene.scene.occluders.push_back({robot.colour, {-0.3, 2.75}, {0.25, 2.95}, 1.0, draw.between(2, 3), 3.5});
    return scene;
}

/// A board before the robot, as camera A sees it, hiding nothing from the other camera.
Occluder boardBeforeRobot(const AccuracyScene &scene, double timeS, double halfWidthM)
{
    const Eigen::Vector2d robot = scene.scene.robots.front().motion->at(timeS).position;
    const Eigen::Vector3d camera = scene.scene.cameras[0].view.cameraInWorld();
    const Eigen::Vector2d way = (camera.head<2>() - robot).normalized();
    const Eigen::Vector2d middle = robot + 0.45 * way, along(-way.y(), way.x());
    return {{120, 96, 70}, middle - halfWidthM * along, middle + halfWidthM * along, 0.75, 0, 1e9};
}

AccuracyScene occluded(SeededDraw &draw)
{
    AccuracyScene scene = emptyScene(draw, 8);
    addRobot(scene, draw, boxRobot("red", red, drawnWander(draw, 9, 0.9)));
    // Put before camera A for a second, wide enough for the way the robot makes meanwhile.
    const double startS = draw.between(2.5, 4.0);
    Occluder board = boardBeforeRobot(scene, startS + 0.5, 0.95);
    board.startS = startS;
    board.durationS = 1.0;
    board.heightM = 1.1;
    scene.scene.occluders.push_back(board);
    return scene;
}

AccuracyScene behindBoard(SeededDraw &draw)
{
    AccuracyScene scene = emptyScene(draw, 8);
    addRobot(scene, draw, boxRobot("green", green, drawnLine(draw, draw.between(4.0, 5.0))));
    scene.scene.occluders.push_back(boardBeforeRobot(scene, 3.2, 0.3));
    return scene;
}

/// Two robots opposite one another on a flat ellipse: they pass one another twice a round, side by side.
AccuracyScene crossing(SeededDraw &draw)
{
    AccuracyScene scene = emptyScene(draw, 10);
    const Eigen::Vector2d centre(draw.between(1.45, 1.55), draw.between(1.0, 1.2));
    const double phase = draw.between(-0.3, 0.3), period = draw.between(3.55, 3.75);
    for (const int i : {0, 1}) {
        SimulatedRobot robot = boxRobot(i == 0 ? "red" : "vermilion", i == 0 ? red : vermilion,
                                        makeEllipseMotion(centre, 0.95, 0.19, period, phase + i * pi, 1.0));
        robot.lengthM = 0.2;
        robot.widthM = 0.15;
        robot.heightM = 0.18;
        addRobot(scene, draw, robot);
    }
    return scene;
}

AccuracyScene threeRobots(SeededDraw &draw)
{
    AccuracyScene scene = emptyScene(draw, 8);
    const Eigen::Vector2d centre(draw.between(1.45, 1.55), draw.between(1.05, 1.15));
    const double phase = draw.between(0, 2 * pi), period = draw.between(4.5, 5.5);
    const std::vector<std::pair<std::string, RgbColour>> robots{
        {"red", red}, {"green", green}, {"blue", blue}};
    for (std::size_t i = 0; i < robots.size(); ++i)
        addRobot(
            scene, draw,
            boxRobot(robots[i].first, robots[i].second,
                     makeEllipseMotion(centre, 0.95, 0.45, period, phase + double(i) * 2 * pi / 3, 1.2)));
    scene.recording.codec = VideoCodec::Mjpeg;
    return scene;
}

AccuracyScene handOver(SeededDraw &draw)
{
    AccuracyScene scene;
    scene.scene = drawnHandOverTestbed(draw);
    scene.scene.durationS = 8;
    addRobot(scene, draw,
             boxRobot("red", red,
                      makeEllipseMotion({1.5, draw.between(1.05, 1.15)}, draw.between(0.95, 1.1),
                                        draw.between(0.4, 0.55), draw.between(5, 6), draw.between(0, 2 * pi),
                                        1.2)));
    return scene;
}

AccuracyScene collision(SeededDraw &draw)
{
    AccuracyScene scene = emptyScene(draw, 7);
    scene.impactsS = {draw.between(3.0, 3.1)};
    addRobot(scene, draw, boxRobot("blue", blue, drawnCollision(draw, scene.impactsS.front())));
    scene.recording.codec = VideoCodec::Mjpeg;
    return scene;
}

} // namespace

const std::vector<std::pair<std::string, AccuracyScene (*)(SeededDraw &)>> &hardScenes()
{
    static const std::vector<std::pair<std::string, AccuracyScene (*)(SeededDraw &)>> scenes{
        {"reflections", reflections},
        {"touching-reflections", touchingReflections},
        {"decoys", decoys},
        {"occluded", occluded},
        {"behind-board", behindBoard},
        {"crossing", crossing},
        {"three-robots", threeRobots},
        {"hand-over", handOver},
        {"collision", collision}};
    return scenes;
}

} // namespace odo::test
