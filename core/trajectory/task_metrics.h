// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <vector>

namespace odo {

/// What a task adds to a run's figures.
struct TaskFigures
{
    std::vector<GatePassage> passages;
    std::vector<Metric> metrics;
};

/// Times at the gates, and how well the reference path was kept; of each only what the task has and the run
/// gave. Metrics, in this order: with a start and a finish apart gate_time (s, the first whole run); with one
/// gate for both laps (1), best_lap and mean_lap (s); with a path cross_track_mean, cross_track_rms,
/// cross_track_max (mm, of the distance without its sign), cross_track_bias (mm, its mean with it, to the left
/// positive) and path_completed (1); with zones those of measureZones. Distances are weighted by the way driven, while the robot moves and is
/// not beyond an end of the path; the maximum is the largest beyond doubt. σ of a distance figure: the track's
/// own noise by first order with its correlation along the run, what that noise alone adds to a mean of
/// magnitudes and by choice to a maximum, and the calibration's part as if it went together everywhere.
TaskFigures measureTask(const Task &task, const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points);

} // namespace odo
