// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/acceptance/scenes/scene_media.h"
#include "tests/acceptance/scenes/scene_metrics.h"

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

struct MeasureSettings
{
    QString program;              ///< the odograph to measure
    std::filesystem::path folder; ///< for the project and the answers (*.json, *.csv)
    double markerErrorPx = 0.3;   ///< sigma of each coordinate of a picked marker
};

/// Makes a project from a scene's media by the command line alone, as a user would: cameras, calibration,
/// layout, registration, robots, import, track, export. Keeps the project and the answers, for which an
/// earlier run's make room, but not the project's copies of the videos.
MeasuredScene measureScene(const AccuracyScene &scene, const SceneMedia &media,
                           const MeasureSettings &settings);

} // namespace odo::test
