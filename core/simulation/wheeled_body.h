// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"

#include <string>
#include <vector>

namespace odo {

/// A wheel that stands on the floor, the middle of its axle above (xM, yM) of the robot's frame.
RobotPart wheelOnFloor(RgbColour colour, double xM, double yM, double radiusM, double widthM);

/// Parts with four wheels added: the middles of their axles at ±xM, ±yM.
std::vector<RobotPart> onFourWheels(std::vector<RobotPart> parts, RgbColour colour, double xM, double yM, double radiusM, double widthM);

/// A robot made of these parts. Its length, width and height are those of the box that holds them with the robot's origin in the middle.
SimulatedRobot robotOfParts(std::string name, std::vector<RobotPart> parts, std::shared_ptr<const Motion> motion);

} // namespace odo
