// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_robots.h"

#include "core/simulation/wheeled_body.h"

#include <algorithm>
#include <numbers>

namespace odo {

namespace {

constexpr double smallestM = 0.03, largestM = 0.5;

double sizeOr(const std::optional<double> &given, double usualM)
{
    return std::clamp(given.value_or(usualM), smallestM, largestM);
}

SimulatedRobot box(const RobotAppearance &appearance)
{
    SimulatedRobot robot;
    robot.colour = *appearance.colour;
    robot.lengthM = sizeOr(appearance.lengthM, robot.lengthM);
    robot.widthM = sizeOr(appearance.widthM, robot.widthM);
    robot.heightM = sizeOr(appearance.heightM, robot.heightM);
    return robot;
}

SimulatedRobot rover(const RobotAppearance &appearance)
{
    constexpr RgbColour rubber{28, 28, 30}, darkGrey{74, 76, 80}, lightGrey{142, 143, 146}, boardGreen{24, 84, 58}, steel{112, 114, 118};
    constexpr double mastM = 0.1, mastThickM = 0.014;
    const double length = sizeOr(appearance.lengthM, 0.22), width = sizeOr(appearance.widthM, 0.192), height = sizeOr(appearance.heightM, 0.098);
    const double wheelRadius = std::min(0.34 * height, 0.15 * length), wheelWidth = 0.146 * width;
    // Levels above the floor: under the chassis, on it, on the deck.
    const double chassisM = 0.85 * wheelRadius, deckM = 0.715 * height, boardM = 0.92 * height;
    const auto upright = [](SimulatedShape shape, RgbColour colour, double xM, const Eigen::Vector2d &acrossM, double fromM, double toM) {
        return RobotPart{shape, colour, {xM, 0, (fromM + toM) / 2}, {acrossM.x(), acrossM.y(), toM - fromM}};
    };
    return robotOfParts({},
                        onFourWheels({upright(SimulatedShape::Box, darkGrey, 0, {length, 0.68 * width}, chassisM, deckM),
                                      upright(SimulatedShape::Box, lightGrey, -0.045 * length, {0.73 * length, 0.57 * width}, deckM, boardM),
                                      upright(SimulatedShape::Box, boardGreen, 0.07 * length, {0.39 * length, 0.29 * width}, boardM, height),
                                      upright(SimulatedShape::Cylinder, steel, -0.295 * length, {mastThickM, mastThickM}, boardM, boardM + mastM)},
                                     rubber, 0.47 * length - wheelRadius, (width - wheelWidth) / 2, wheelRadius, wheelWidth),
                        nullptr);
}

} // namespace

SimulatedRobot demoRobot(std::string name, const RobotAppearance &appearance, std::shared_ptr<const Motion> motion)
{
    SimulatedRobot robot = appearance.colour ? box(appearance) : rover(appearance);
    robot.name = std::move(name);
    robot.motion = std::move(motion);
    return robot;
}

std::vector<SimulatedRobot> circlingRobots(const std::vector<RobotAppearance> &appearances)
{
    constexpr std::size_t onACircle = 4, most = 8;
    constexpr double outerM = 0.75, innerM = 0.4, periodS = 2 * std::numbers::pi * outerM / 1.1;
    const Eigen::Vector2d middle(1.5, 1.1);
    if (appearances.empty())
        return circlingRobots({{.colour = demoBlue}});
    std::vector<SimulatedRobot> robots;
    const std::size_t count = std::min(appearances.size(), most), outside = std::min(count, onACircle);
    for (std::size_t i = 0; i < count; ++i) {
        const bool isOutside = i < outside;
        const auto place = double(isOutside ? i : i - outside), places = double(isOutside ? outside : count - outside);
        const double radiusM = isOutside ? outerM : innerM;
        robots.push_back(demoRobot(std::to_string(i + 1), appearances[i],
                                   makeEllipseMotion(middle, radiusM, radiusM, periodS, 2 * std::numbers::pi * place / places, 1.5)));
    }
    return robots;
}

} // namespace odo
