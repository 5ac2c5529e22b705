// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"

#include <vector>

namespace odo {

/// Adds SpeedLimit and AccelerationLimit to samples that were refused as a Jump and would break the limits of
/// `options` with the nearest used samples on both sides.
void nameLimits(std::vector<Sample> &samples, const AnalysisOptions &options);

/// Refuses used samples, with AccelerationLimit, where the task tells a limit: the acceleration from the
/// nearest used sample before to that behind is beyond it by more than four σ of the three measurements
/// (their stated covariance times noiseScale). Of neighbours the one that is furthest beyond is refused first,
/// for it drags the others along. Samples that a person has judged are left as they are; a bound of speed is
/// kept by the search for spikes.
void refuseBeyondTask(std::vector<Sample> &samples, const AnalysisOptions &options, double noiseScale);

} // namespace odo
