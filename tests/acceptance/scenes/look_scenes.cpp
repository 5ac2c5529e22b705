// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/look_scenes.h"

#include "tests/acceptance/scenes/drawn_motions.h"
#include "tests/acceptance/scenes/drawn_testbed.h"
#include "tests/acceptance/scenes/look_robots.h"
#include "tests/acceptance/scenes/scene_robots.h"

#include <numbers>

namespace odo::test {

namespace {

/// One of the ways that robots make, drawn.
SharedMotion drawnWay(SeededDraw &draw)
{
    switch (draw.whole(0, 3)) {
    case 0:
        return drawnCircle(draw);
    case 1:
        return drawnFigureEight(draw, draw.between(1.0, 1.4));
    case 2:
        return drawnStopAndGo(draw);
    default:
        return drawnWander(draw, 9, 0.9);
    }
}

AccuracyScene onTestbed(SimulatedScene testbed, SeededDraw &draw, Look look, bool hasGivenSize = false)
{
    AccuracyScene scene;
    scene.scene = std::move(testbed);
    scene.scene.durationS = 8;
    addRobot(scene, draw, robotOfLook(look, drawnWay(draw)), hasGivenSize);
    scene.given.front().colour.clear();
    return scene;
}

AccuracyScene withLook(SeededDraw &draw, Look look, const Corners &corners = nearSide,
                       bool hasGivenSize = false)
{
    return onTestbed(drawnTestbed(draw, corners), draw, look, hasGivenSize);
}

void setLamp(AccuracyScene &scene, SeededDraw &draw, double strength)
{
    scene.scene.lamps = {Lamp{{draw.between(0.0, 3.0), draw.between(-0.3, 2.5), draw.between(2.2, 2.8)},
                              draw.between(0.08, 0.2),
                              strength}};
}

AccuracyScene vacuum(SeededDraw &draw)
{
    return withLook(draw, Look::Vacuum);
}
AccuracyScene sphere(SeededDraw &draw)
{
    return withLook(draw, Look::Sphere, across);
}
AccuracyScene whiteBox(SeededDraw &draw)
{
    return withLook(draw, Look::WhiteBox);
}
AccuracyScene twoColours(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::TwoColours);
    setLamp(scene, draw, 0.3);
    return scene;
}
AccuracyScene hovering(SeededDraw &draw)
{
    return withLook(draw, Look::Hovering);
}
AccuracyScene buggy(SeededDraw &draw)
{
    return withLook(draw, Look::Buggy, across);
}
AccuracyScene rover(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::Rover);
    setLamp(scene, draw, 0.3);
    return scene;
}
AccuracyScene roverTold(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::WhiteRover, nearSide, true);
    setLamp(scene, draw, 0.3);
    return scene;
}
AccuracyScene smallBlack(SeededDraw &draw)
{
    return withLook(draw, Look::SmallBlack);
}
AccuracyScene trackedPlainFloor(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::Tracked);
    scene.scene.floor.textureAmplitude = 0.01;
    setLamp(scene, draw, 0.4);
    return scene;
}
AccuracyScene cable(SeededDraw &draw)
{
    return withLook(draw, Look::Cable);
}
AccuracyScene boards(SeededDraw &draw)
{
    return withLook(draw, Look::Boards, across);
}
AccuracyScene likeTheFloor(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::LikeTheFloor);
    setLamp(scene, draw, 0.3);
    return scene;
}
AccuracyScene greyLamp(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::GreyRover);
    setLamp(scene, draw, 0.3);
    return scene;
}
AccuracyScene greyPlainFloor(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::GreyRover);
    scene.scene.floor.textureAmplitude = 0.01;
    setLamp(scene, draw, 0.4);
    return scene;
}
AccuracyScene onPlainFloor(SeededDraw &draw, Look look, double strength)
{
    AccuracyScene scene = withLook(draw, look);
    scene.scene.floor.textureAmplitude = 0.01;
    setLamp(scene, draw, strength);
    return scene;
}
AccuracyScene darkPlainFloor(SeededDraw &draw)
{
    return onPlainFloor(draw, Look::DarkRover, 0.4);
}
AccuracyScene greyDeepShadow(SeededDraw &draw)
{
    return onPlainFloor(draw, Look::GreyRover, 0.68);
}
AccuracyScene whiteDeepShadow(SeededDraw &draw)
{
    return onPlainFloor(draw, Look::WhiteRover, 0.68);
}
AccuracyScene blackDeepShadow(SeededDraw &draw)
{
    return onPlainFloor(draw, Look::SmallBlack, 0.68);
}
AccuracyScene darkDeepShadow(SeededDraw &draw)
{
    return onPlainFloor(draw, Look::DarkRover, 0.68);
}
AccuracyScene glossyFloor(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::WhiteRover);
    scene.scene.floor.gloss = 0.25;
    return scene;
}
AccuracyScene darkTiles(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::Rover);
    scene.scene.floor.colour = {84, 80, 78};
    scene.scene.floor.tileM = 0.25;
    scene.scene.floor.textureAmplitude = 0.15;
    return scene;
}
/// Its sides are as dark as a shadow could be here, and the lamps are so wide that none is.
AccuracyScene trackedDarkMat(SeededDraw &draw)
{
    AccuracyScene scene = onPlainFloor(draw, Look::Tracked, 0.15);
    scene.scene.floor.colour = {62, 62, 66};
    return scene;
}
AccuracyScene lightDrifts(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::Buggy);
    for (SimulatedCamera &camera : scene.scene.cameras) {
        camera.sensor.gainDriftPerS = draw.between(-0.02, 0.02);
        camera.sensor.flickerAmplitude = 0.03;
    }
    return scene;
}
AccuracyScene sunComes(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::Rover);
    scene.scene.localLights = {{{draw.between(0.8, 2.2), draw.between(0.6, 1.6)},
                                draw.between(0.5, 0.9),
                                draw.between(0.15, 0.25),
                                draw.between(0, 2),
                                4}};
    return scene;
}
AccuracyScene lampIsLit(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::WhiteRover, across);
    scene.scene.lights = {{draw.between(1.15, 1.3), draw.between(2, 5), 1e9}};
    return scene;
}
AccuracyScene rollingShutter(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::Rover);
    for (SimulatedCamera &camera : scene.scene.cameras)
        camera.sensor.readoutS = draw.between(0.008, 0.016);
    return scene;
}
AccuracyScene buggyBeforeThree(SeededDraw &draw)
{
    return withLook(draw, Look::Buggy, {Corner::NearLeft, Corner::NearRight, Corner::FarLeft});
}
AccuracyScene highCameras(SeededDraw &draw)
{
    return onTestbed(drawnTestbedFrom(draw, 2.6, 3.2), draw, Look::Rover);
}
AccuracyScene lowCameras(SeededDraw &draw)
{
    return onTestbed(drawnTestbedFrom(draw, 1.1, 1.4), draw, Look::Buggy);
}
AccuracyScene mjpeg(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::WhiteRover);
    scene.recording.codec = VideoCodec::Mjpeg;
    return scene;
}
/// A person along the far side, some time within the run.
SimulatedRobot passingPerson(SeededDraw &draw)
{
    const double y = draw.between(2.25, 2.45);
    return walkingPerson(makeLineMotion({-0.2, y}, {3.2, y}, draw.between(0.5, 2), 5));
}
SimulatedRobot crossingBall(SeededDraw &draw)
{
    return rollingBall(makeLineMotion({draw.between(0.1, 0.5), draw.between(1.8, 2.1)},
                                      {draw.between(2.5, 2.9), draw.between(0.1, 0.4)}, draw.between(1, 3),
                                      4));
}
/// It comes in over the near side, stays and goes.
SimulatedRobot passingHand(SeededDraw &draw)
{
    const Eigen::Vector2d outside(draw.between(0.6, 2.4), -1.6), velocity(0, draw.between(1.05, 1.25));
    const double comesS = draw.between(0.5, 2), staysS = draw.between(0.3, 1.2);
    constexpr double rampS = 0.3, wayS = 1.4;
    return reachingHand(makeVelocityMotion(outside, std::numbers::pi / 2,
                                           {{comesS, rampS, velocity},
                                            {comesS + wayS, rampS, -velocity},
                                            {comesS + wayS + staysS, rampS, -velocity},
                                            {comesS + 2 * wayS + staysS, rampS, velocity}}));
}
AccuracyScene personWalks(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::Rover);
    scene.scene.bystanders = {passingPerson(draw)};
    return scene;
}
AccuracyScene ballRolls(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::WhiteRover);
    scene.scene.bystanders = {crossingBall(draw)};
    return scene;
}
AccuracyScene handReachesIn(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::Buggy);
    scene.scene.bystanders = {passingHand(draw)};
    return scene;
}
AccuracyScene twoPeople(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::GreyRover);
    scene.scene.bystanders = {
        passingPerson(draw), walkingPerson(makeLineMotion({3.0, -0.5}, {0.2, -0.45}, draw.between(1, 3), 4))};
    setLamp(scene, draw, 0.3);
    return scene;
}
AccuracyScene everythingAtOnce(SeededDraw &draw)
{
    AccuracyScene scene = withLook(draw, Look::Boards);
    scene.scene.bystanders = {passingPerson(draw), crossingBall(draw), passingHand(draw)};
    scene.scene.floor.gloss = 0.15;
    scene.scene.lights = {{1.2, draw.between(3, 5), 1e9}};
    setLamp(scene, draw, 0.25);
    return scene;
}
/// It waits where it begins while a ball rolls by.
AccuracyScene ballBeforeTheStart(SeededDraw &draw)
{
    AccuracyScene scene;
    scene.scene = drawnTestbed(draw, nearSide);
    scene.scene.durationS = 10;
    addRobot(scene, draw, robotOfLook(Look::Vacuum, makeLineMotion({0.5, 0.6}, {2.5, 1.4}, 5, 4)), false);
    scene.given.front().colour.clear();
    scene.scene.bystanders = {rollingBall(makeLineMotion({0.4, 1.9}, {2.8, 1.7}, 0.5, 3))};
    return scene;
}
AccuracyScene twoAlike(SeededDraw &draw)
{
    AccuracyScene scene;
    scene.scene = drawnTestbed(draw, nearSide);
    scene.scene.durationS = 10;
    const double phase = draw.between(0, 6.28), period = draw.between(5, 6);
    for (const int i : {0, 1}) {
        SimulatedRobot robot = robotOfLook(
            Look::WhiteRover, makeEllipseMotion({1.5, 1.1}, 0.9, 0.5, period, phase + 3.14159 * i, 1.0));
        robot.name += std::to_string(i + 1);
        addRobot(scene, draw, robot, false);
        scene.given.back().colour.clear();
    }
    return scene;
}

} // namespace

const std::vector<std::pair<std::string, AccuracyScene (*)(SeededDraw &)>> &lookScenes()
{
    static const std::vector<std::pair<std::string, AccuracyScene (*)(SeededDraw &)>> scenes{
        {"look-vacuum", vacuum},
        {"look-sphere", sphere},
        {"look-white-box", whiteBox},
        {"look-two-colours", twoColours},
        {"look-hovering", hovering},
        {"look-buggy", buggy},
        {"look-rover", rover},
        {"look-rover-told", roverTold},
        {"look-small-black", smallBlack},
        {"look-tracked", trackedPlainFloor},
        {"look-cable", cable},
        {"look-boards", boards},
        {"look-like-the-floor", likeTheFloor},
        {"look-grey", greyLamp},
        {"look-grey-plain-floor", greyPlainFloor},
        {"look-dark-plain-floor", darkPlainFloor},
        {"look-grey-deep-shadow", greyDeepShadow},
        {"look-white-deep-shadow", whiteDeepShadow},
        {"look-black-deep-shadow", blackDeepShadow},
        {"look-dark-deep-shadow", darkDeepShadow},
        {"look-glossy-floor", glossyFloor},
        {"look-dark-tiles", darkTiles},
        {"look-tracked-dark-mat", trackedDarkMat},
        {"look-light-drifts", lightDrifts},
        {"look-sun-comes", sunComes},
        {"look-lamp-is-lit", lampIsLit},
        {"look-rolling-shutter", rollingShutter},
        {"look-three-cameras", buggyBeforeThree},
        {"look-high-cameras", highCameras},
        {"look-low-cameras", lowCameras},
        {"look-mjpeg", mjpeg},
        {"look-person", personWalks},
        {"look-ball", ballRolls},
        {"look-hand", handReachesIn},
        {"look-two-people", twoPeople},
        {"look-everything", everythingAtOnce},
        {"look-ball-before", ballBeforeTheStart},
        {"look-two-alike", twoAlike}};
    return scenes;
}

} // namespace odo::test
