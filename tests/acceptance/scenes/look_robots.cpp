// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/look_robots.h"

#include "core/simulation/demo_testbed.h"

#include <cassert>

namespace odo::test {

namespace {

using S = SimulatedShape;
using Parts = std::vector<RobotPart>;

constexpr RgbColour black{28, 28, 30}, white{238, 238, 235}, grey{120, 120, 122}, darkGrey{62, 62, 64},
    asFloor{182, 177, 166}, paintRed{200, 35, 40}, yellow{215, 190, 40}, deepGreen{50, 140, 60},
    deepBlue{30, 60, 150}, board{20, 90, 60}, skin{205, 160, 135};

/// A body with four black wheels.
Parts onWheels(Parts parts, double x, double y, double radiusM, double widthM)
{
    return onFourWheels(std::move(parts), black, x, y, radiusM, widthM);
}

Parts chassis(RgbColour colour)
{
    return onWheels({{S::Box, colour, {0, 0, 0.05}, {0.22, 0.14, 0.05}}}, 0.07, 0.085, 0.03, 0.028);
}

Parts buggy()
{
    return {{S::Box, paintRed, {0, 0, 0.034}, {0.21, 0.13, 0.032}},
            {S::Box, deepBlue, {-0.03, 0, 0.072}, {0.11, 0.10, 0.044}},
            wheelOnFloor(black, -0.055, 0.08, 0.035, 0.03),
            wheelOnFloor(black, -0.055, -0.08, 0.035, 0.03),
            {S::Sphere, grey, {0.08, 0, 0.009}, {0.018, 0.018, 0.018}}};
}

Parts rover()
{
    return onWheels({{S::Box, paintRed, {0, 0, 0.045}, {0.25, 0.15, 0.046}},
                     {S::Box, yellow, {-0.02, 0, 0.078}, {0.14, 0.11, 0.02}},
                     {S::Cylinder, grey, {-0.06, 0, 0.148}, {0.016, 0.016, 0.12}}},
                    0.085, 0.09, 0.033, 0.03);
}

Parts tracked()
{
    return {{S::Box, black, {0, 0.08, 0.03}, {0.24, 0.045, 0.06}},
            {S::Box, black, {0, -0.08, 0.03}, {0.24, 0.045, 0.06}},
            {S::Box, deepGreen, {0.01, 0, 0.06}, {0.2, 0.114, 0.05}}};
}

Parts withCable()
{
    Parts parts = chassis(white);
    parts.push_back({S::Box, black, {-0.17, 0.03, 0.05}, {0.12, 0.006, 0.006}});
    return parts;
}

Parts openBoards()
{
    Parts parts = onWheels({{S::Box, board, {0, 0, 0.034}, {0.2, 0.12, 0.004}},
                            {S::Box, board, {0, 0, 0.082}, {0.16, 0.1, 0.004}},
                            {S::Box, grey, {-0.04, 0, 0.048}, {0.07, 0.05, 0.024}}},
                           0.065, 0.078, 0.0325, 0.026);
    for (const double x : {0.07, -0.07})
        for (const double y : {0.04, -0.04})
            parts.push_back({S::Cylinder, yellow, {x, y, 0.058}, {0.008, 0.008, 0.044}});
    return parts;
}

Parts partsOf(Look look)
{
    switch (look) {
    case Look::Vacuum:
        return {{S::Cylinder, black, {0, 0, 0.05}, {0.30, 0.30, 0.08}}};
    case Look::Sphere:
        return {{S::Sphere, white, {0, 0, 0.09}, {0.18, 0.18, 0.18}}};
    case Look::WhiteBox:
        return {{S::Box, white, {0, 0, 0.04}, {0.24, 0.17, 0.08}}};
    case Look::TwoColours:
        return {{S::Box, paintRed, {0.06, 0, 0.045}, {0.12, 0.16, 0.09}},
                {S::Box, deepBlue, {-0.06, 0, 0.045}, {0.12, 0.16, 0.09}}};
    case Look::Hovering:
        return {{S::Box, paintRed, {0, 0, 0.038}, {0.26, 0.19, 0.06}}};
    case Look::Buggy:
        return buggy();
    case Look::Rover:
        return rover();
    case Look::WhiteRover:
        return chassis(white);
    case Look::GreyRover:
        return chassis(grey);
    case Look::DarkRover:
        return chassis(darkGrey);
    case Look::SmallBlack:
        return onWheels({{S::Box, black, {0, 0, 0.03}, {0.12, 0.08, 0.03}}}, 0.04, 0.05, 0.02, 0.02);
    case Look::Tracked:
        return tracked();
    case Look::Cable:
        return withCable();
    case Look::Boards:
        return openBoards();
    case Look::LikeTheFloor:
        return onWheels({{S::Box, asFloor, {0, 0, 0.06}, {0.26, 0.16, 0.06}}}, 0.085, 0.095, 0.035, 0.03);
    }
    assert(false);
    return {};
}

} // namespace

SimulatedRobot robotOfLook(Look look, std::shared_ptr<const Motion> motion)
{
    return robotOfParts("robot", partsOf(look), std::move(motion));
}

SimulatedRobot walkingPerson(std::shared_ptr<const Motion> motion)
{
    const RgbColour trousers{40, 50, 90};
    return robotOfParts("person",
                        {{S::Cylinder, trousers, {0, 0.1, 0.45}, {0.15, 0.15, 0.9}},
                         {S::Cylinder, trousers, {0, -0.1, 0.45}, {0.15, 0.15, 0.9}},
                         {S::Cylinder, {150, 60, 60}, {0, 0, 1.3}, {0.35, 0.35, 0.8}}},
                        std::move(motion));
}

SimulatedRobot reachingHand(std::shared_ptr<const Motion> motion)
{
    return robotOfParts("hand",
                        {{S::Box, skin, {0, 0, 0.1}, {0.18, 0.09, 0.05}},
                         {S::Box, {60, 70, 110}, {-0.99, 0, 0.16}, {1.8, 0.1, 0.1}}},
                        std::move(motion));
}

SimulatedRobot rollingBall(std::shared_ptr<const Motion> motion)
{
    return robotOfParts("ball", {{S::Sphere, {230, 120, 30}, {0, 0, 0.035}, {0.07, 0.07, 0.07}}},
                        std::move(motion));
}

} // namespace odo::test
