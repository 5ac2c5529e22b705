// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"

#include <string>
#include <vector>

namespace odo::test {

/// What stands in a classroom: robots of parts, most without a colour of their own. The origin is the middle
/// of the footprint's bounding rectangle.
enum class Look {
    Vacuum,      ///< round, black, close to the floor
    Sphere,      ///< white
    WhiteBox,    ///< plain, on the floor
    TwoColours,  ///< a box, red before and blue behind
    Hovering,    ///< a red box that begins 8 mm above the floor
    Buggy,       ///< two wheels and a caster, red, with a blue upper part to the rear
    Rover,       ///< four black wheels, red, with a deck and a mast
    WhiteRover,  ///< four black wheels, white
    GreyRover,   ///< four black wheels, grey
    DarkRover,   ///< four black wheels, dark grey
    SmallBlack,  ///< four black wheels, 120 × 80 mm, black
    Tracked,     ///< green between two black tracks
    Cable,       ///< a white rover with a cable behind, which is no part of its footprint
    Boards,      ///< open: two plates on posts, motors and a battery between them
    LikeTheFloor ///< of the floor's own colour, with dark wheels
};

SimulatedRobot robotOfLook(Look look, std::shared_ptr<const Motion> motion);

/// A person, a hand at the end of an arm that reaches in from above, a ball.
SimulatedRobot walkingPerson(std::shared_ptr<const Motion> motion);
SimulatedRobot reachingHand(std::shared_ptr<const Motion> motion);
SimulatedRobot rollingBall(std::shared_ptr<const Motion> motion);

} // namespace odo::test
