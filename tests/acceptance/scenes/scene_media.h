// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "tests/acceptance/scenes/scene_catalogue.h"

#include <filesystem>

namespace odo::test {

/// The files that the program is given, in the folder of a scene and seed.
struct SceneMedia
{
    std::filesystem::path folder;

    std::filesystem::path video(const SimulatedCamera &camera) const
    {
        return folder / (camera.name + ".mkv");
    }
    std::filesystem::path board(const SimulatedCamera &camera, int number) const;
    std::filesystem::path layout() const { return folder / "layout.csv"; }
    /// Where a robot truly was, at the stamps of the first camera's frames: for people who look into a
    /// figure.
    std::filesystem::path truth(const SimulatedRobot &robot) const
    {
        return folder / ("truth_" + robot.name + ".csv");
    }
};

constexpr int boardImages = 14;

/// Renders the videos of all cameras, 14 pictures of a board for each, and writes the layout and where each
/// marker is seen, with a Gaussian error of 0.3 px. What an earlier run rendered from the same recipe is
/// kept.
Result<SceneMedia> provideMedia(const AccuracyScene &scene, const std::filesystem::path &folder);

} // namespace odo::test
