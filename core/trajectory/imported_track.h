// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/analyser.h"

#include <optional>
#include <vector>

namespace odo {

/// A track that another program measured, as it was imported: positions in metres in the world frame, in order of time.
/// Nothing here alters them: they are the raw measurement. All functions are pure and thread-safe.

/// One line of such a track.
struct ImportedPosition
{
    Nanoseconds time{0};
    std::optional<Eigen::Vector2d> position; ///< empty: the robot was not measured then
    std::optional<Eigen::Vector2d> sigmaM;   ///< of x and y, where it is stated
};

/// The samples of such a track; Sample::frame is the line's index, no view is named. Positions without a stated σ get noiseM.
std::vector<Sample> samplesOfImported(const std::vector<ImportedPosition> &track, double noiseM);

/// How far the positions scatter from frame to frame, metres: what the motion noise's maximum likelihood leaves over for the
/// measurement (estimateMotionNoise), spikes left out. At least leastImportedNoiseM.
double estimateImportedNoiseM(const std::vector<ImportedPosition> &track);
constexpr double leastImportedNoiseM = 1e-4; ///< no camera measures finer, and numbers that were rounded look as if it did

/// The root mean square σ of a coordinate, metres; 0 without a position.
double noiseLevelM(const std::vector<Sample> &samples);

/// Analyses imported samples as those of our own views are: spikes, profile, metrics. Gaps are bridged over four times the usual
/// interval where that is longer than the options say, which gets into the options. Undetermined where fewer than
/// three positions can be used.
Result<Profile> analyseImported(const std::vector<Sample> &raw, const AnalysisOptions &options);
/// The options with which a track of these times is analysed.
AnalysisOptions optionsForImported(AnalysisOptions options, const std::vector<Sample> &raw);

} // namespace odo
