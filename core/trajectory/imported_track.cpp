// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/imported_track.h"

#include "core/analysis/metrics.h"
#include "core/analysis/profile.h"
#include "core/analysis/task_metrics.h"
#include "core/base/percentile.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/heading_curve.h"
#include "core/trajectory/internal/spike_flags.h"
#include "core/trajectory/internal/track_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

constexpr double firstNoiseM = 0.001, mostNoiseM = 1;
constexpr int noiseRounds = 3;
constexpr std::size_t noisePositions = 20000; // say as much of the noise as an hour of them
// A stated σ counts as ours do: it says where the scale begins, and many positions say more.
constexpr double statedTrust = 200;

void addIntervals(const std::vector<Sample> &samples, std::vector<double> &seconds)
{
    for (std::size_t i = 1; i < samples.size(); ++i)
        seconds.push_back(toSeconds(samples[i].time - samples[i - 1].time));
}

AnalysisOptions withUsualInterval(AnalysisOptions options, std::vector<double> seconds)
{
    const Nanoseconds usual = seconds.empty() ? Nanoseconds(0) : fromSeconds(upperMedian(std::move(seconds)));
    options.longestBridgedGap = std::max(options.longestBridgedGap, bridgedIntervals * usual);
    return options;
}

/// Where a long track is learnt from: stretches all over it.
constexpr std::size_t learntStretches = 10, learntLength = 4096;

std::size_t startOfStretch(std::size_t stretch, std::size_t count)
{
    return stretch * (count - learntLength) / (learntStretches - 1);
}

/// A part of a long track, with what is read on both sides of it: no smoother and no search reaches further.
constexpr std::size_t partLength = 16'384, margin = 1024;

Message chooseLonger()
{
    return ODO_TEXT("trajectory.choose_longer_track", "choose a track with more positions");
}

/// What all tracks of this kind are analysed with. A stated σ counts as ours do.
MeasurementNoise importedNoise()
{
    MeasurementNoise measurement;
    measurement.trust = statedTrust;
    measurement.mayWobble = true;
    return measurement;
}

constexpr double leastHeadingSigmaRad = 1e-4;
constexpr double leastAlongRatio = 10; // of a path along a heading that never changes, to its width

/// Whether headings that never change are those of a robot that drives along them, forwards or backwards, and
/// not what a program writes that knows none.
bool liesAlong(const std::vector<ImportedPosition> &track, double headingRad)
{
    Eigen::Vector2d sum = Eigen::Vector2d::Zero(), squares = Eigen::Vector2d::Zero();
    double count = 0;
    const Eigen::Rotation2Dd back(-headingRad);
    for (const ImportedPosition &one : track) {
        if (!one.position)
            continue;
        const Eigen::Vector2d position = back * Eigen::Vector2d(*one.position);
        sum += position;
        squares += position.cwiseAbs2();
        count += 1;
    }
    const Eigen::Vector2d spread = (squares / count - (sum / count).cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
    return spread.x() > leastAlongRatio * std::max(spread.y(), leastImportedNoiseM);
}

/// Whether the headings of a track are of its robot.
bool saysHeading(const std::vector<ImportedPosition> &track)
{
    std::optional<double> first;
    for (const ImportedPosition &one : track) {
        if (!one.headingRad)
            continue;
        if (first && *one.headingRad != *first)
            return true;
        first = one.headingRad;
    }
    return first && liesAlong(track, *first);
}

/// How far the headings scatter, as estimateImportedNoiseM of positions.
double estimateHeadingSigmaRad(const std::vector<ImportedPosition> &track)
{
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < std::min(noisePositions, track.size()); ++i) {
        Sample &sample = samples.emplace_back();
        sample.time = track[i].time;
        if (!track[i].position || !track[i].headingRad)
            continue;
        sample.position = *track[i].position;
        sample.heading = MeasuredHeading{*track[i].headingRad, 0, 0};
    }
    return std::max(leastHeadingSigmaRad,
                    headingScatterRad(samples, optionsForImported({}, samples).longestBridgedGap));
}

} // namespace

std::vector<Sample> samplesOfImported(const std::vector<ImportedPosition> &track, double noiseM)
{
    const ImportedSeries series(track, noiseM);
    std::vector<Sample> samples;
    samples.reserve(track.size());
    for (std::size_t i = 0; i < series.size(); ++i)
        samples.push_back(series.sample(i));
    return samples;
}

ImportedSeries::ImportedSeries(const std::vector<ImportedPosition> &track, double noiseM) : m_noiseM(noiseM)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const bool isStated =
        std::ranges::any_of(track, [](const ImportedPosition &one) { return one.sigmaM.has_value(); });
    m_times.reserve(track.size());
    m_positions.reserve(track.size());
    m_sigmas.reserve(isStated ? track.size() : 0);
    for (const ImportedPosition &one : track) {
        m_times.push_back(one.time);
        m_positions.push_back(one.position ? std::array{one.position->x(), one.position->y()}
                                           : std::array{none, none});
        if (isStated)
            m_sigmas.push_back(one.sigmaM ? std::array{one.sigmaM->x(), one.sigmaM->y()}
                                          : std::array{noiseM, noiseM});
    }
    if (!saysHeading(track))
        return;
    for (const ImportedPosition &one : track)
        m_headings.push_back(one.headingRad.value_or(none));
    m_headingSigmaRad = estimateHeadingSigmaRad(track);
}

Sample ImportedSeries::sample(std::size_t i) const
{
    Sample sample;
    sample.time = m_times[i];
    sample.frame = static_cast<std::int64_t>(i);
    if (!m_headings.empty() && !std::isnan(m_headings[i]))
        sample.heading = MeasuredHeading{m_headings[i], m_headingSigmaRad, 0};
    if (std::isnan(m_positions[i][0])) {
        sample.flags = flagBit(SampleFlag::Lost);
        return sample;
    }
    sample.position = Eigen::Vector2d(m_positions[i][0], m_positions[i][1]);
    const auto [x, y] = m_sigmas.empty() ? std::array{m_noiseM, m_noiseM} : m_sigmas[i];
    sample.covariance = Eigen::Vector2d(x * x, y * y).asDiagonal();
    return sample;
}

double estimateImportedNoiseM(const std::vector<ImportedPosition> &track, const JobControl &control)
{
    std::vector<ImportedPosition> part(
        track.begin(), track.begin() + static_cast<std::ptrdiff_t>(std::min(noisePositions, track.size())));
    for (ImportedPosition &one : part)
        one.sigmaM.reset();
    double noiseM = firstNoiseM;
    for (int round = 0; round < noiseRounds && !control.isCancelled(); ++round) {
        std::vector<Sample> samples = samplesOfImported(part, noiseM);
        const SpikeVerdict verdict = flagSpikes(samples, optionsForImported({}, samples));
        const double estimated = noiseM * std::sqrt(verdict.noise.measurementScale);
        noiseM =
            std::isfinite(estimated) ? std::clamp(estimated, leastImportedNoiseM, mostNoiseM) : firstNoiseM;
    }
    return noiseM;
}

double noiseLevelM(const std::vector<Sample> &samples)
{
    NoiseLevel level;
    level.add(samples);
    return level.sigmaM();
}

AnalysisOptions optionsForImported(AnalysisOptions options, const std::vector<Sample> &raw)
{
    std::vector<double> seconds;
    addIntervals(raw, seconds);
    return withUsualInterval(std::move(options), std::move(seconds));
}

Result<AnalysisOptions> optionsForImported(AnalysisOptions options, const SampleSource &raw)
{
    std::vector<double> seconds;
    const bool isLong = raw.count > longestAtOnce;
    for (std::size_t stretch = 0; stretch < (isLong ? learntStretches : 1); ++stretch) {
        const auto samples = ODO_TRY(isLong ? raw.chunk(startOfStretch(stretch, raw.count), learntLength)
                                            : raw.chunk(0, raw.count));
        addIntervals(samples, seconds);
    }
    return withUsualInterval(std::move(options), std::move(seconds));
}

Result<Profile> analyseImported(const std::vector<Sample> &raw, const AnalysisOptions &options)
{
    auto profile = ODO_TRY(analyseImported(sourceOf(raw), options, {}));
    profile.samples = raw;
    for (std::size_t i = 0; i < raw.size(); ++i)
        profile.samples[i].flags = profile.flags[i];
    profile.flags.clear();
    return profile;
}

namespace {

FusedTrack trackOf(std::vector<Sample> samples, const AnalysisOptions &options)
{
    FusedTrack track;
    track.evidence.resize(samples.size());
    track.samples = std::move(samples);
    applyOverrides(track.samples, options.overrides);
    return track;
}

Result<Profile> analyseAtOnce(std::vector<Sample> samples, const AnalysisOptions &options)
{
    auto profile = ODO_TRY(profileOfTrack(trackOf(std::move(samples), options), options, importedNoise()));
    profile.flags.reserve(profile.samples.size());
    for (const Sample &sample : profile.samples)
        profile.flags.push_back(sample.flags);
    profile.samples = {};
    return profile;
}

/// Analyses a long track part by part; what is kept of each is what its margins do not hold.
class PartedAnalysis
{
public:
    PartedAnalysis(const SampleSource &raw, const AnalysisOptions &options, const JobControl &control)
        : m_raw(raw), m_options(options), m_control(control)
    {
        m_profile.points.reserve(raw.count);
        m_profile.flags.reserve(raw.count);
        m_instants.reserve(raw.count);
    }

    Result<Profile> run()
    {
        ODO_TRY(learn());
        for (std::size_t begin = 0; begin < m_raw.count; begin += partLength) {
            if (m_control.isCancelled())
                return cancelled(cannotMeasurePath());
            m_control.report(double(begin) / double(m_raw.count),
                             ODO_TEXT("trajectory.analysing_position", "analysing position %1")(begin));
            ODO_TRY(addPart(begin, std::min(begin + partLength, m_raw.count)));
        }
        return finish();
    }

private:
    Result<void> learn()
    {
        std::vector<Sample> learnt;
        for (std::size_t stretch = 0; stretch < learntStretches; ++stretch) {
            auto samples = ODO_TRY(m_raw.chunk(startOfStretch(stretch, m_raw.count), learntLength));
            learnt.insert(learnt.end(), samples.begin(), samples.end());
        }
        applyOverrides(learnt, m_options.overrides);
        m_known = flagSpikes(learnt, m_options, importedNoise());
        return {};
    }

    Result<void> addPart(std::size_t begin, std::size_t end)
    {
        const std::size_t from = begin - std::min(begin, margin), to = std::min(end + margin, m_raw.count);
        auto samples = ODO_TRY(m_raw.chunk(from, to - from));
        FusedTrack track = trackOf(std::move(samples), m_options);
        const std::vector<MotionChange> changes = flagSpikesKnowing(m_known, track.samples, m_options);
        auto points = makePoints(track.samples, changes, m_options, m_known.noise);
        smoothHeadings(track.samples, m_options.longestBridgedGap, points);
        for (Spike &spike : describeSpikes(track, points, m_options.longestBridgedGap)) {
            const std::size_t at = from + static_cast<std::size_t>(spike.sampleIndex);
            if (at < begin || at >= end)
                continue;
            spike.sampleIndex = static_cast<std::int64_t>(at);
            m_profile.spikes.push_back(std::move(spike));
        }
        for (std::size_t i = begin - from; i < end - from; ++i) {
            m_profile.points.push_back(points[i]);
            m_profile.flags.push_back(track.samples[i].flags);
            m_used += isUsed(track.samples[i]);
        }
        appendInstants(std::span(track.samples).subspan(begin - from, end - begin),
                       std::span(m_profile.points).subspan(begin), m_state, m_instants);
        return {};
    }

    Result<Profile> finish()
    {
        if (m_used < 3 || m_instants.empty())
            return notEnoughData(m_raw.count, m_used, chooseLonger());
        m_profile.metrics = measureRun(m_instants);
        measureGaps(m_instants, m_profile);
        m_instants = {};
        if (m_options.task)
            ODO_TRY(measureByTask());
        return std::move(m_profile);
    }

    /// Gates, path and zones are searched along all samples.
    Result<void> measureByTask()
    {
        auto samples = ODO_TRY(m_raw.chunk(0, m_raw.count));
        for (std::size_t i = 0; i < samples.size(); ++i)
            samples[i].flags = m_profile.flags[i];
        TaskMetrics metrics = measureTask(*m_options.task, samples, m_profile.points);
        m_profile.passages = std::move(metrics.passages);
        m_profile.metrics.insert(m_profile.metrics.end(), metrics.metrics.begin(), metrics.metrics.end());
        return {};
    }

    const SampleSource &m_raw;
    const AnalysisOptions &m_options;
    const JobControl &m_control;
    SpikeVerdict m_known;
    Profile m_profile;
    std::vector<RunInstant> m_instants;
    RunState m_state;
    std::size_t m_used = 0;
};

} // namespace

Result<Profile> analyseImported(const SampleSource &raw, const AnalysisOptions &options,
                                const JobControl &control)
{
    if (raw.count > longestAtOnce)
        return PartedAnalysis(raw, options, control).run();
    auto samples = ODO_TRY(raw.chunk(0, raw.count));
    auto profile = analyseAtOnce(std::move(samples), options);
    if (profile)
        return profile;
    Error error = profile.error();
    error.advice = chooseLonger();
    return tl::unexpected(error);
}

} // namespace odo
