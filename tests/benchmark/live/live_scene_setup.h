// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"

namespace odo::test {

/// What is filmed while it is measured: the demo's testbed with one robot that goes round and round.
struct LiveScene
{
    SimulatedScene scene;
    std::int64_t firstFrame = 0; ///< from here to the last the robot drives whole rounds at its full speed
};

/// What the robot looks like: a red disc, or a rover of many colours that none is given of.
enum class LiveRobot { Coloured, AnyLook };

/// Two views of this size and rate; 1280 by 720 is the demo's own, others see the same with more pixels.
LiveScene liveScene(int widthPx, double framesPerSecond, LiveRobot robot = LiveRobot::Coloured);

} // namespace odo::test
