// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/fused_track.h"

#include <optional>
#include <vector>

namespace odo {

/// The views joined, before the search for spikes.
struct MeasuredRobot
{
    FusedTrack track;
    MeasurementNoise noise;
    double heightM = 0;
    bool heightEstimated = false;
    std::optional<double> clearanceM;
    std::optional<ViewsContradiction> contradiction;
};

/// Projects the views onto the floor, settles what makes them contradict each other, and joins them. Where
/// they contradict each other with the given height, and agree without it on a form that is no higher, the
/// height is of something at the robot's top that its outlines hardly show (a mast, a button): then the form
/// is found without it. At least one view is registered. Pure. Errors: those of positionRobot, and views that
/// are exchanged.
Result<MeasuredRobot> measureRobot(const std::vector<ViewTrack> &views, const RobotShape &shape,
                                   const AnalysisOptions &options);

} // namespace odo
