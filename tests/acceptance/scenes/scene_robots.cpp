// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/scene_robots.h"

#include <algorithm>
#include <cmath>

namespace odo::test {

namespace {

constexpr double colourErrorCodes = 6; // sigma of a channel

std::uint8_t pickedChannel(std::uint8_t value, SeededDraw &draw)
{
    return static_cast<std::uint8_t>(
        std::clamp(std::lround(value + draw.gaussian(colourErrorCodes)), 0l, 255l));
}

std::string millimetresText(double metres)
{
    return std::to_string(std::lround(metres * 1000));
}

} // namespace

SimulatedRobot boxRobot(const std::string &name, RgbColour colour, std::shared_ptr<const Motion> motion)
{
    SimulatedRobot robot;
    robot.name = name;
    robot.colour = colour;
    robot.motion = std::move(motion);
    return robot;
}

void addRobot(AccuracyScene &scene, SeededDraw &draw, const SimulatedRobot &robot, bool hasGivenSize)
{
    const RgbColour &shown = robot.colour;
    const RgbColour picked{pickedChannel(shown.red, draw), pickedChannel(shown.green, draw),
                           pickedChannel(shown.blue, draw)};
    GivenRobot given{robot.name, picked.toString(), {}, {}};
    if (hasGivenSize) {
        given.height = millimetresText(robot.heightM) + "mm";
        given.size = millimetresText(robot.lengthM) + "x" + millimetresText(robot.widthM);
    }
    scene.scene.robots.push_back(robot);
    scene.given.push_back(given);
}

} // namespace odo::test
