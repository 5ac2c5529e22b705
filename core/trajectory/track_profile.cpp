// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/track_profile.h"

#include "core/trajectory/metrics.h"
#include "core/trajectory/profile_points.h"
#include "core/trajectory/spike_flags.h"
#include "core/trajectory/task_metrics.h"

#include <algorithm>

namespace odo {

namespace {

constexpr std::size_t leastSamples = 3; // an acceleration needs three positions

} // namespace

const char *const cannotMeasurePath = "the robot's path cannot be measured";

Result<Profile> profileOfTrack(FusedTrack track, const AnalysisOptions &options, const MeasurementNoise &measurement)
{
    const SpikeVerdict verdict = flagSpikes(track.samples, options, measurement);
    Profile profile;
    profile.points = makePoints(track.samples, verdict.struck, options, verdict.noise);
    const auto used = std::count_if(track.samples.begin(), track.samples.end(), [](const Sample &sample) {
        return sample.position && !isRejected(sample.flags);
    });
    const bool anyValid = std::any_of(profile.points.begin(), profile.points.end(),
                                      [](const ProfilePoint &point) { return point.valid; });
    if (static_cast<std::size_t>(used) < leastSamples || !anyValid)
        return fail(ErrorCode::Undetermined, cannotMeasurePath,
                    "not enough data: of " + std::to_string(track.samples.size()) + " frames " +
                        std::to_string(used) + " give a position that can be used",
                    "choose a longer video, or check the robot's colour and the light");
    profile.spikes = describeSpikes(track, profile.points, options.longestBridgedGap);
    profile.metrics = measureRun(track.samples, profile.points);
    if (options.task) {
        TaskFigures figures = measureTask(*options.task, track.samples, profile.points);
        profile.passages = std::move(figures.passages);
        profile.metrics.insert(profile.metrics.end(), figures.metrics.begin(), figures.metrics.end());
    }
    profile.samples = std::move(track.samples);
    return profile;
}

} // namespace odo
