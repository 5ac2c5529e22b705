// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/base/error.h"
#include "core/simulation/scene.h"
#include "core/workflow/track/view_tracking.h"

#include <QString>
#include <filesystem>
#include <optional>
#include <vector>

namespace odo::test {

/// What was measured of a scene's first robot, against the truth.
struct SceneMetrics
{
    double foundShare = 0; ///< of the first view's frames
    double rmsM = 0;
    double insideShare = 0; ///< of the coordinates that the stated 95 % hold
    double velocityRms = 0, accelerationRms = 0;
    int spikes = 0;
    double disagreeShare = 0; ///< of the frames, in which the views contradict one another
    double bodyShare = 0;     ///< of the frames, in which the heading is the body's
    /// of those: heading, and turn rate, that are within two stated σ
    double headingInside = 0, turnRateInside = 0;
    double headingRmsRad = 0, turnRateRms = 0;
    std::optional<Metric> fastestTurn;

    QString words() const;
};

/// The scene's videos, rendered into a folder, of cameras that are known exactly.
Result<std::vector<RegisteredView>> renderedViews(const SimulatedScene &scene,
                                                  const std::filesystem::path &folder);

/// Tracks and analyses rendered views. robot: what is told of the scene's first one.
Result<SceneMetrics> measuredByViews(const SimulatedScene &scene, const std::vector<RegisteredView> &views,
                                     const RobotRecord &robot);
/// Renders the scene's videos, tracks and analyses them by cameras that are known exactly.
Result<SceneMetrics> measuredScene(const SimulatedScene &scene, const std::optional<RgbColour> &colour = {});

} // namespace odo::test
