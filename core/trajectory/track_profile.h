// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/fused_track.h"
#include "core/trajectory/kalman_smoother.h"

namespace odo {

/// Samples → spikes → profile → metrics: what becomes of a track wherever its positions come from, our own views or a
/// file. Height and disagreement of the views are left at 0. measurement: of the samples' covariances. Pure and
/// thread-safe. Undetermined where fewer than three positions can be used.
Result<Profile> profileOfTrack(FusedTrack track, const AnalysisOptions &options, const MeasurementNoise &measurement);

/// How the errors of analysing begin: "the robot's path cannot be measured".
extern const char *const cannotMeasurePath;

} // namespace odo
