// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/robot_appearance.h"
#include "core/simulation/scene.h"

#include <string>
#include <vector>

namespace odo {

inline constexpr RgbColour demoRed{0xd7, 0x23, 0x28}, demoBlue{0x1f, 0x6f, 0xd0}, demoGreen{0x1f, 0x9d, 0x4d};

/// A robot as the demo draws it. One with a colour is a plain box, by default of 260 × 190 × 60 mm. One without is what most classrooms have, in
/// greys and black: a chassis on four wheels with a deck, a circuit board and a mast, by default 220 × 192 mm and 98 mm high without the mast.
/// Sizes are kept between 30 and 500 mm, to fit on the floor.
SimulatedRobot demoRobot(std::string name, const RobotAppearance &appearance, std::shared_ptr<const Motion> motion);

/// Robots that drive the circle of the demo's task Circle all day at 1.1 m/s, one behind the other; a fifth and later ones, eight in all, a smaller circle
/// inside it. None given: a blue box.
std::vector<SimulatedRobot> circlingRobots(const std::vector<RobotAppearance> &appearances);

} // namespace odo
