// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"

#include <string>
#include <vector>

namespace odo {

/// A camera looking at a point of the floor from a place in the room, with a mild barrel distortion.
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
/// The demo's class: four teams, three with a box of its own colour and one with a wheeled robot without a colour; straight line, circle (twice),
/// figure eight, stop-and-go; one trial with reflections that make spikes. Each lasts 6 to 10 s.
std::vector<DemoTrial> demoTrials();

} // namespace odo
