// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/simulation/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// What is known of how a robot looks.
struct RobotAppearance
{
    std::optional<RgbColour> colour = {}; ///< none: it may have any look
    std::optional<double> lengthM = {}, widthM = {}, heightM = {};
};

/// A camera looking at a point of the floor from a position in the room, with a mild barrel distortion.
FloorView simulatedView(const Eigen::Vector3d &cameraInWorld, const Eigen::Vector3d &lookAtInWorld,
                        int widthPx, int heightPx, double focalPx);

/// The testbed that `odograph demo` and the tests use: two oblique cameras 2 m high, 1280×720, 30 frames/s,
/// over a floor of about 3 m × 2.2 m with the markers O, U, V, D, no robots yet. The seed is that of
/// the noise; the floor is always the same.
SimulatedScene demoTestbed(std::uint32_t seed);

/// One of the demo's trials.
struct DemoTrial
{
    std::string trial, team, robot, task;
    SimulatedScene scene;
};
/// The demo's class: four teams, three with a box of its own colour and one with a wheeled robot without a
/// colour; straight line, circle (twice), figure eight, stop-and-go; one trial with reflections that make
/// spikes. Each lasts 6 to 10 s.
std::vector<DemoTrial> demoTrials();

inline constexpr RgbColour demoRed{0xd7, 0x23, 0x28}, demoBlue{0x1f, 0x6f, 0xd0}, demoGreen{0x1f, 0x9d, 0x4d};

/// A robot as the demo draws it. One with a colour is a plain box, by default of 260 × 190 × 60 mm. One
/// without is what most classrooms have, in greys and black: a chassis on four wheels with a deck, a circuit
/// board and a mast, by default 220 × 192 mm and 98 mm high without the mast. Sizes are kept between 30 and
/// 500 mm, to fit on the floor.
SimulatedRobot demoRobot(std::string name, const RobotAppearance &appearance,
                         std::shared_ptr<const Motion> motion);

/// Robots that drive the circle of the demo's task Circle all day at 1.1 m/s, one behind the other; a fifth
/// and later ones, eight in all, a smaller circle inside it. None given: a blue box.
std::vector<SimulatedRobot> circlingRobots(const std::vector<RobotAppearance> &appearances);

/// A wheel on the floor, the middle of its axle above (xM, yM) of the robot's frame.
RobotPart wheelOnFloor(RgbColour colour, double xM, double yM, double radiusM, double widthM);

/// Parts with four wheels added: the middles of their axles at ±xM, ±yM.
std::vector<RobotPart> onFourWheels(std::vector<RobotPart> parts, RgbColour colour, double xM, double yM,
                                    double radiusM, double widthM);

/// A robot made of these parts. Its length, width and height are those of the box that holds them with the
/// robot's origin in the middle.
SimulatedRobot robotOfParts(std::string name, std::vector<RobotPart> parts,
                            std::shared_ptr<const Motion> motion);

} // namespace odo
