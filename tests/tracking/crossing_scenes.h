// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/demo_testbed.h"
#include "core/simulation/scene.h"

#include <string>
#include <vector>

namespace odo::test {

/// How two robots meet again and again. They never come nearer than 0.33 m (centres), but cover one another
/// in pictures taken from low.
enum class Meeting {
    Pass,       ///< they run past one another five times
    TurnBack,   ///< they run up to one another and back again, four times
    BehindWall, ///< as Pass, beside a board that hides the second meeting from some cameras
};

struct CrossingSettings
{
    std::vector<RgbColour> colours;
    Meeting meeting = Meeting::Pass;
    double cameraHeightM = 2.0;
    double robotHeightM = 0.06;
    std::uint32_t seed = 1;
};

/// A robot that shuttles along y between two ends, with smooth turns.
inline std::shared_ptr<const Motion> shuttle(double y, double fromX, double toX, int legs, double legS)
{
    // Knots in the middle and at a slight bow outwards, so that it is no straight line.
    std::vector<Eigen::Vector2d> points{{fromX, y}};
    const double bow = y > 1 ? 0.12 : -0.12; // away from the others
    for (int leg = 0; leg < legs; ++leg) {
        const bool there = leg % 2 == 0;
        const double middle = 0.5 * (fromX + toX), end = there ? toX : fromX;
        points.push_back({middle, y});
        points.push_back({end, y + bow});
    }
    return makeSplineMotion(std::move(points), legS / 2);
}

/// Two robots on the demo's floor, between y = 0.85 and 1.2 m. Cameras A and B look from two corners; C along
/// y.
inline SimulatedScene crossingScene(const CrossingSettings &settings)
{
    SimulatedScene scene = demoTestbed(settings.seed);
    const double z = settings.cameraHeightM;
    scene.cameras = {
        {"A", simulatedView({-0.9, -1.55, z}, {1.4, 0.75, 0.0}, 1280, 720, 960), 30, 0, 0, {}},
        {"B", simulatedView({3.9, -1.55, z}, {1.6, 0.75, 0.0}, 1280, 720, 940), 30, 0.011, 0, {}},
        {"C", simulatedView({1.5, -1.9, z}, {1.5, 0.9, 0.0}, 1280, 720, 900), 30, 0.005, 0, {}}};
    const double legS = 1.9 + 0.05 * (settings.seed % 3);
    const bool pass = settings.meeting != Meeting::TurnBack;
    const int legs = pass ? 5 : 8;
    scene.durationS = legs * legS + 0.5;
    const auto add = [&](const std::string &name, RgbColour colour, std::shared_ptr<const Motion> motion) {
        SimulatedRobot robot;
        robot.name = name;
        robot.colour = colour;
        robot.heightM = settings.robotHeightM;
        robot.motion = std::move(motion);
        scene.robots.push_back(std::move(robot));
    };
    const double gap = 0.34 + 0.02 * (settings.seed % 3);
    add("one", settings.colours[0], shuttle(0.85, 0.6, pass ? 2.4 : 1.44, legs, legS));
    add("two", settings.colours[1], shuttle(0.85 + gap, 2.4, pass ? 0.6 : 1.56, legs, legS));
    if (settings.colours.size() > 2)
        add("three", settings.colours[2], shuttle(0.85 + 2 * gap, 0.6, 2.4, legs, legS));
    if (settings.meeting == Meeting::BehindWall)
        scene.occluders.push_back({{120, 122, 118}, {1.2, 0.5}, {1.8, 0.5}, 0.5, 1.3 * legS, 0.5});
    return scene;
}

} // namespace odo::test
