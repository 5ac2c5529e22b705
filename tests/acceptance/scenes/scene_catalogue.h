// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"
#include "core/video/video_writer.h"

#include <string>
#include <vector>

namespace odo::test {

/// What the program is told of a robot; empty where it is not.
struct GivenRobot
{
    std::string name, colour, height, size;
};

/// Which bars hold: those of the plain scenes of coloured solids, those of such with spikes, occlusion or
/// several robots, or those of robots of any look.
enum class SceneKind { Plain, Hard, Look };

/// One simulated recording with known truth, and what the program is told of it.
struct AccuracyScene
{
    std::string name;
    unsigned seed = 1;
    SceneKind kind = SceneKind::Plain;
    SimulatedScene scene;
    std::vector<GivenRobot> given; ///< as scene.robots
    bool findsOffset = false;      ///< the clips' offset is to be found, not told
    bool oneView = false;          ///< seen by one camera: counted for coverage only
    std::vector<double> impactsS;  ///< collisions: no curve is smooth there
    VideoWriterOptions recording;

    bool hasGivenSize() const { return !given.front().size.empty(); }
};

/// Those of a kind, in the order in which they are measured.
std::vector<std::string> sceneNames(SceneKind kind);
std::vector<std::string> allSceneNames();
/// The scene of a name with all that a seed draws. The name must be one of allSceneNames().
AccuracyScene makeScene(const std::string &name, unsigned seed);

} // namespace odo::test
