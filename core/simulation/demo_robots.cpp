// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_robots.h"

#include "core/simulation/wheeled_body.h"

namespace odo {

SimulatedRobot demoBox(std::string name, RgbColour colour, std::shared_ptr<const Motion> motion)
{
    SimulatedRobot robot;
    robot.name = std::move(name);
    robot.colour = colour;
    robot.motion = std::move(motion);
    return robot;
}

SimulatedRobot demoRover(std::string name, std::shared_ptr<const Motion> motion)
{
    constexpr RgbColour rubber{28, 28, 30}, darkGrey{74, 76, 80}, lightGrey{142, 143, 146}, boardGreen{24, 84, 58}, steel{112, 114, 118};
    return robotOfParts(std::move(name),
                        onFourWheels({{SimulatedShape::Box, darkGrey, {0, 0, 0.049}, {0.22, 0.13, 0.042}},
                                      {SimulatedShape::Box, lightGrey, {-0.01, 0, 0.080}, {0.16, 0.11, 0.02}},
                                      {SimulatedShape::Box, boardGreen, {0.015, 0, 0.094}, {0.085, 0.056, 0.008}},
                                      {SimulatedShape::Cylinder, steel, {-0.065, 0, 0.140}, {0.014, 0.014, 0.1}}},
                                     rubber, 0.07, 0.082, 0.033, 0.028),
                        std::move(motion));
}

} // namespace odo
