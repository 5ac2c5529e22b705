// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/wheeled_body.h"

namespace odo {

RobotPart wheelOnFloor(RgbColour colour, double xM, double yM, double radiusM, double widthM)
{
    return {SimulatedShape::Wheel, colour, {xM, yM, radiusM}, {2 * radiusM, widthM, 2 * radiusM}};
}

std::vector<RobotPart> onFourWheels(std::vector<RobotPart> parts, RgbColour colour, double xM, double yM, double radiusM, double widthM)
{
    for (const double atX : {xM, -xM})
        for (const double atY : {yM, -yM})
            parts.push_back(wheelOnFloor(colour, atX, atY, radiusM, widthM));
    return parts;
}

SimulatedRobot robotOfParts(std::string name, std::vector<RobotPart> parts, std::shared_ptr<const Motion> motion)
{
    SimulatedRobot robot;
    robot.name = std::move(name);
    robot.motion = std::move(motion);
    Eigen::Vector3d upper = Eigen::Vector3d::Zero();
    for (const RobotPart &part : parts)
        upper = upper.cwiseMax(part.upper());
    robot.lengthM = 2 * upper.x(); // the origin is the middle
    robot.widthM = 2 * upper.y();
    robot.heightM = upper.z();
    robot.parts = std::move(parts);
    return robot;
}

} // namespace odo
