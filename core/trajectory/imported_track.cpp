// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/imported_track.h"

#include "core/base/upper_median.h"
#include "core/trajectory/overrules.h"
#include "core/trajectory/spike_flags.h"
#include "core/trajectory/track_profile.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double firstNoiseM = 0.001, mostNoiseM = 1;
constexpr int noiseRounds = 3;
constexpr std::size_t noisePositions = 20000; // say as much of the noise as an hour of them
constexpr int bridgedIntervals = 4;
// A stated σ counts as ours do: it says where the scale begins, and many positions say more.
constexpr double statedTrust = 200;

Nanoseconds usualInterval(const std::vector<Sample> &samples)
{
    std::vector<double> seconds;
    for (std::size_t i = 1; i < samples.size(); ++i)
        seconds.push_back(toSeconds(samples[i].time - samples[i - 1].time));
    return seconds.empty() ? Nanoseconds(0) : fromSeconds(upperMedian(std::move(seconds)));
}

} // namespace

std::vector<Sample> samplesOfImported(const std::vector<ImportedPosition> &track, double noiseM)
{
    std::vector<Sample> samples(track.size());
    for (std::size_t i = 0; i < track.size(); ++i) {
        Sample &sample = samples[i];
        sample.time = track[i].time;
        sample.frame = static_cast<std::int64_t>(i);
        sample.position = track[i].position;
        if (!sample.position) {
            sample.flags = flagBit(SampleFlag::Lost);
            continue;
        }
        const Eigen::Vector2d sigmaM = track[i].sigmaM.value_or(Eigen::Vector2d(noiseM, noiseM));
        sample.covariance = sigmaM.cwiseAbs2().asDiagonal();
    }
    return samples;
}

double estimateImportedNoiseM(const std::vector<ImportedPosition> &track)
{
    std::vector<ImportedPosition> part(track.begin(),
                                       track.begin() + static_cast<std::ptrdiff_t>(std::min(noisePositions, track.size())));
    for (ImportedPosition &one : part)
        one.sigmaM.reset();
    double noiseM = firstNoiseM;
    for (int round = 0; round < noiseRounds; ++round) {
        std::vector<Sample> samples = samplesOfImported(part, noiseM);
        const SpikeVerdict verdict = flagSpikes(samples, optionsForImported({}, samples));
        const double estimated = noiseM * std::sqrt(verdict.noise.measurementScale);
        noiseM = std::isfinite(estimated) ? std::clamp(estimated, leastImportedNoiseM, mostNoiseM) : firstNoiseM;
    }
    return noiseM;
}

double noiseLevelM(const std::vector<Sample> &samples)
{
    double variances = 0, count = 0;
    for (const Sample &sample : samples) {
        if (!sample.position)
            continue;
        variances += sample.covariance.trace();
        count += 2;
    }
    return count > 0 ? std::sqrt(variances / count) : 0;
}

AnalysisOptions optionsForImported(AnalysisOptions options, const std::vector<Sample> &raw)
{
    options.longestBridgedGap = std::max(options.longestBridgedGap, bridgedIntervals * usualInterval(raw));
    return options;
}

Result<Profile> analyseImported(const std::vector<Sample> &raw, const AnalysisOptions &options)
{
    FusedTrack track;
    track.samples = raw;
    track.evidence.resize(raw.size());
    applyOverrules(track.samples, options.overrules);
    MeasurementNoise measurement;
    measurement.trust = statedTrust;
    auto profile = profileOfTrack(std::move(track), options, measurement);
    if (profile)
        return profile;
    Error error = profile.error();
    error.advice = "choose a track with more positions";
    return tl::unexpected(error);
}

} // namespace odo
