// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/acceptance/scenes/scene_figures.h"
#include "tests/acceptance/scenes/scene_media.h"

#include <QJsonObject>
#include <QString>
#include <optional>

namespace odo::test {

/// What measuring one scene and seed gave.
struct MeasuredScene
{
    AccuracyScene scene;
    std::vector<AccuracySums> robots;   ///< as scene.scene.robots
    std::optional<double> offsetErrorS; ///< where the offset was to be found
    double wallS = 0;                   ///< of the program's calls
    QString problem;                    ///< the call that failed, and its error; empty when all went well

    AccuracySums sums() const;
};

/// Makes a project from a scene's media by the command line alone, as a user would: cameras, calibration,
/// layout, registration, robots, import, track, export; keeps the project and the answers (*.json, *.csv) in
/// the folder, where an earlier run's make room, but not the project's copies of the videos.
MeasuredScene measureScene(const QString &program, const AccuracyScene &scene, const SceneMedia &media,
                           const std::filesystem::path &folder);

} // namespace odo::test
