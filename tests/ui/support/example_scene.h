// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <filesystem>

namespace odo {

struct ExampleOptions
{
    int frames = 300; ///< at 30 a second
    int robots = 1;   ///< the second drives the same course later
    int widthPx = 640, heightPx = 360;
    std::filesystem::path videoFolder{}; ///< where the videos are made; empty: the files are missing
};

/// A trial with known curves: two oblique cameras without distortion over a floor of 3 m × 2.2 m, a robot
/// that drives a figure eight, three spikes. The videos show a grey floor with a grid and a red box.
TrialScenePtr exampleScene(const ExampleOptions &options);

/// The true position at a time, in metres.
Eigen::Vector2d examplePosition(double seconds, int robot = 0);

} // namespace odo
