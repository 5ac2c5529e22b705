// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/spike_flags.h"

#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/motion_levels.h"
#include "core/trajectory/internal/motion_noise.h"
#include "core/trajectory/internal/spike_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace odo {

namespace {

constexpr double sigmasBeyond = 4;
constexpr int mostLimitPasses = 8;

/// Three samples in order of time and the motion between them.
struct Triple
{
    const Sample &before, &at, &behind;

    double in() const { return toSeconds(at.time - before.time); }
    double out() const { return toSeconds(behind.time - at.time); }
    Eigen::Vector2d speedIn() const { return (*at.position - *before.position) / in(); }
    Eigen::Vector2d speedOut() const { return (*behind.position - *at.position) / out(); }
    double accelMps2() const { return (speedOut() - speedIn()).norm() / ((in() + out()) / 2); }
    double sigmaAccelMps2() const
    {
        const auto variance = [](const Sample &sample) { return sample.covariance.trace() / 2; };
        const double rates = variance(before) / (in() * in()) + variance(behind) / (out() * out()) +
                             variance(at) * std::pow(1 / in() + 1 / out(), 2);
        return std::sqrt(rates) / ((in() + out()) / 2);
    }
};

/// By how much each of the used samples is beyond the limit; not above zero where it keeps it.
std::vector<double> excesses(const std::vector<Sample *> &used, const AnalysisOptions &options,
                             double noiseScale)
{
    std::vector<double> beyond(used.size());
    for (std::size_t i = 1; i + 1 < used.size(); ++i) {
        const Triple triple{*used[i - 1], *used[i], *used[i + 1]};
        const Nanoseconds longest = options.longestBridgedGap;
        if (triple.in() <= 0 || triple.out() <= 0 || triple.at.time - triple.before.time > longest ||
            triple.behind.time - triple.at.time > longest)
            continue;
        beyond[i] = triple.accelMps2() - sigmasBeyond * std::sqrt(noiseScale) * triple.sigmaAccelMps2() -
                    *options.task->limits.maxAccelMps2;
    }
    return beyond;
}

} // namespace

/// Adds SpeedLimit and AccelerationLimit to samples that were refused as a Jump and would break the limits of
/// `options` with the nearest used samples on both sides.
void nameLimits(std::vector<Sample> &samples, const AnalysisOptions &options)
{
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!samples[i].position || !hasFlag(samples[i].flags, SampleFlag::Jump) ||
            hasFlag(samples[i].flags, SampleFlag::ByHand))
            continue;
        // The nearest used neighbours stand for the motion.
        std::optional<std::size_t> before, behind;
        for (std::size_t j = i; j-- > 0 && !before;) {
            if (isUsed(samples[j]))
                before = j;
        }
        for (std::size_t j = i + 1; j < samples.size() && !behind; ++j) {
            if (isUsed(samples[j]))
                behind = j;
        }
        if (!before || !behind)
            continue;
        const Triple triple{samples[*before], samples[i], samples[*behind]};
        if (std::min(triple.speedIn().norm(), triple.speedOut().norm()) > options.maxSpeedMps)
            samples[i].flags |= flagBit(SampleFlag::SpeedLimit);
        if (triple.accelMps2() > options.maxAccelMps2)
            samples[i].flags |= flagBit(SampleFlag::AccelerationLimit);
    }
}

/// Refuses used samples, with AccelerationLimit, if the task sets a limit: the acceleration from the nearest
/// used sample before to that behind is beyond it by more than four σ of the three measurements (their stated
/// covariance times noiseScale). Of neighbours the one that is furthest beyond is refused first, because it
/// drags the others along. Samples that a person has judged are left as they are; a bound of speed is kept by
/// the search for spikes.
void refuseBeyondTask(std::vector<Sample> &samples, const AnalysisOptions &options, double noiseScale)
{
    if (!options.task || !options.task->limits.maxAccelMps2)
        return;
    bool any = true;
    for (int pass = 0; any && pass < mostLimitPasses; ++pass) {
        std::vector<Sample *> used;
        for (Sample &sample : samples) {
            if (isUsed(sample))
                used.push_back(&sample);
        }
        const std::vector<double> beyond = excesses(used, options, noiseScale);
        any = false;
        for (std::size_t i = 1; i + 1 < used.size(); ++i) {
            if (beyond[i] <= 0 || beyond[i] < beyond[i - 1] || beyond[i] <= beyond[i + 1] ||
                hasFlag(used[i]->flags, SampleFlag::ByHand))
                continue;
            used[i]->flags |= flagBit(SampleFlag::AccelerationLimit);
            any = true;
        }
    }
}

namespace {

constexpr int mostPasses = 6;
// Between rest and a hard start the noise estimated from a whole run knows little of either; and a run with
// many faults must not teach that everything is possible.
constexpr double leastJerkDensity = 1, largestJerkDensity = 1000;
constexpr double firstJerkDensity = 10;
constexpr double leastScale = 0.25;

/// One round of searching in all segments of open samples.
struct Round
{
    std::vector<bool> spike; ///< of each sample
    std::vector<bool> abrupt, struck;

    explicit Round(std::size_t samples) : spike(samples), abrupt(samples), struck(samples) {}
};

Round searchAll(const std::vector<Sample> &samples, const std::vector<bool> &open, MotionNoise noise,
                const AnalysisOptions &options)
{
    noise.jerkDensity = std::clamp(noise.jerkDensity, leastJerkDensity, largestJerkDensity);
    noise.measurementScale = std::max(noise.measurementScale, leastScale);
    Round round(samples.size());
    const auto isOpen = [&](const Sample &sample) {
        return open[static_cast<std::size_t>(&sample - samples.data())];
    };
    for (const TrackSegment &segment : cutIntoSegments(samples, options.longestBridgedGap, isOpen)) {
        const SpikeSearch found = searchSpikes(segment.nodes, noise, options.maxSpeedMps);
        for (std::size_t i = 0; i < segment.nodes.size(); ++i) {
            round.spike[segment.first + i] = found.spike[i];
            round.abrupt[segment.first + i] = found.abrupt[i];
            round.struck[segment.first + i] = found.struck[i];
        }
    }
    return round;
}

/// The noise of the stretches between abrupt changes, spikes left out.
MotionNoise noiseBetweenChanges(const std::vector<Sample> &samples, const std::vector<bool> &open,
                                const Round &round, const AnalysisOptions &options)
{
    const auto isUsed = [&](const Sample &sample) {
        const auto i = static_cast<std::size_t>(&sample - samples.data());
        return open[i] && !round.spike[i];
    };
    const auto segments = cutIntoSegments(samples, options.longestBridgedGap, isUsed);
    std::vector<std::span<const TrackNode>> stretches;
    for (const TrackSegment &segment : segments) {
        const std::span<const TrackNode> nodes(segment.nodes);
        std::size_t begin = 0;
        for (std::size_t i = 1; i <= nodes.size(); ++i) {
            if (i < nodes.size() && !round.abrupt[segment.first + i])
                continue;
            stretches.push_back(nodes.subspan(begin, i - begin));
            begin = i;
        }
    }
    return estimateMotionNoise(stretches, false);
}

/// The noise before anything is known of the motion. Third differences of positions see the noise and hardly
/// the motion (of a jerk of 30 m/s³ a millimetre at 30 frames/s), and their median deviation hardly the
/// faults.
MotionNoise firstNoise(const std::vector<Sample> &samples, const std::vector<bool> &open, const Round &round,
                       const AnalysisOptions &options)
{
    constexpr double sumOfSquares = 20; // of the weights 1, −3, 3, −1
    const auto isUsed = [&](const Sample &sample) {
        const auto i = static_cast<std::size_t>(&sample - samples.data());
        return open[i] && !round.spike[i];
    };
    std::vector<double> differences; // in standard deviations
    for (const TrackSegment &segment : cutIntoSegments(samples, options.longestBridgedGap, isUsed)) {
        const auto &nodes = segment.nodes;
        for (std::size_t i = 3; i < nodes.size(); ++i) {
            if (!nodes[i - 3].measured || !nodes[i - 2].measured || !nodes[i - 1].measured ||
                !nodes[i].measured)
                continue;
            const Eigen::Vector2d third = nodes[i].position - 3 * nodes[i - 1].position +
                                          3 * nodes[i - 2].position - nodes[i - 3].position;
            for (int axis : {0, 1})
                differences.push_back(third[axis] /
                                      std::sqrt(sumOfSquares * nodes[i].covariance(axis, axis)));
        }
    }
    const double deviation = differences.empty() ? 1 : medianDeviation(differences);
    MotionNoise noise;
    noise.jerkDensity = firstJerkDensity;
    noise.measurementScale = deviation * deviation;
    return noise;
}

std::size_t countUsed(const std::vector<Sample> &samples)
{
    return static_cast<std::size_t>(std::count_if(samples.begin(), samples.end(), [](const Sample &sample) {
        return sample.position && !isRejected(sample.flags);
    }));
}

/// A first guess of the outliers, by Hampel's identifier on position and speed. Only the first estimate of
/// the noise leaves them out; whether they are spikes is for the search to say.
Round outlying(const std::vector<Sample> &samples, const std::vector<bool> &open,
               const AnalysisOptions &options)
{
    Round round(samples.size());
    const auto isOpen = [&](const Sample &sample) {
        return open[static_cast<std::size_t>(&sample - samples.data())];
    };
    for (const TrackSegment &segment : cutIntoSegments(samples, options.longestBridgedGap, isOpen)) {
        const auto outliers = hampelSpikes(segment.nodes);
        for (std::size_t i = 0; i < outliers.size(); ++i)
            round.spike[segment.first + i] = outliers[i].any();
    }
    return round;
}

/// What is used, parted at the blows that were found, and the noise that it was told with.
struct LearntMotion
{
    std::vector<TrackSegment> segments;
    MotionNoise noise;
    double usualDensity = 0; ///< of the jerk, if the motion were as lively all the time
};

std::vector<TrackSegment> partedSegments(const std::vector<Sample> &samples, const Round &round,
                                         const AnalysisOptions &options)
{
    std::vector<MotionChange> blows(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        blows[i].struck = round.struck[i];
    auto segments = cutIntoSegments(samples, options.longestBridgedGap);
    markChanges(segments, blows);
    return segments;
}

/// A noise for the whole run shows where the motion is lively and where it is not, and that what the noise
/// is.
LearntMotion learnMotion(const std::vector<Sample> &samples, const Round &round,
                         const AnalysisOptions &options, MeasurementNoise measurement)
{
    constexpr int rounds = 2;
    LearntMotion learnt{partedSegments(samples, round, options), {}, 0};
    const auto nodes = nodesOf(learnt.segments);
    learnt.noise = estimateMotionNoise(nodes, false, measurement);
    if (measurement.mayWobble) {
        measurement = withWobble(nodes, measurement, learnt.noise);
        if (measurement.wobbleM > 0)
            learnt.noise = estimateMotionNoise(nodes, false, measurement);
    }
    learnt.usualDensity = learnt.noise.jerkDensity;
    for (int i = 0; i < rounds; ++i) {
        adaptToMotion(learnt.segments, learnt.noise, learnt.usualDensity);
        learnt.noise = estimateMotionNoise(nodes, false, measurement);
    }
    return learnt;
}

std::vector<MotionChange> changesOf(const LearntMotion &learnt, const Round &round)
{
    std::vector<MotionChange> changes(round.struck.size());
    for (std::size_t i = 0; i < changes.size(); ++i)
        changes[i].struck = round.struck[i];
    for (const TrackSegment &segment : learnt.segments)
        for (std::size_t i = 0; i < segment.nodes.size(); ++i)
            changes[segment.first + i].liveliness = segment.nodes[i].liveliness;
    return changes;
}

/// Refuses samples that are outliers among their neighbours by Hampel's identifier, and lie further from the
/// smoothed track than their noise lets them. At an abrupt change of motion they may.
void flagOutliers(std::vector<Sample> &samples, const Round &round, const LearntMotion &learnt)
{
    constexpr double gate = 30;            // χ²(2): 1 in 3 million
    constexpr double leastShareOpen = 0.1; // of the noise: what the track leaves, having used the sample too
    for (const TrackSegment &segment : learnt.segments) {
        const auto outliers = hampelSpikes(segment.nodes);
        if (std::none_of(outliers.begin(), outliers.end(), [](HampelSpike one) { return one.any(); }))
            continue;
        smoothMotion(segment.nodes, learnt.noise, [&](std::size_t i, const MotionEstimate &track) {
            const std::size_t at = segment.first + i;
            const bool abrupt = round.abrupt[at] || (at > 0 && round.abrupt[at - 1]) ||
                                (at + 1 < samples.size() && round.abrupt[at + 1]);
            if (!outliers[i].any() || abrupt || hasFlag(samples[at].flags, SampleFlag::ByHand))
                return;
            const Eigen::Matrix2d measured = learnt.noise.measurementScale * segment.nodes[i].covariance +
                                             std::pow(learnt.noise.wobbleM, 2) * Eigen::Matrix2d::Identity();
            const Eigen::Matrix2d left = measured - track.covariance.topLeftCorner<2, 2>();
            const double variance = std::max(left.trace(), leastShareOpen * measured.trace()) / 2;
            if ((segment.nodes[i].position - track.position()).squaredNorm() > gate * variance)
                samples[at].flags |= flagBit(SampleFlag::Jump);
        });
    }
}

} // namespace

namespace {

/// Samples refused for another reason before are not judged again.
std::vector<bool> openSamples(const std::vector<Sample> &samples)
{
    std::vector<bool> open(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        open[i] = samples[i].position && !isRejected(samples[i].flags);
    return open;
}

void flagFound(std::vector<Sample> &samples, const Round &round)
{
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (round.spike[i] && !hasFlag(samples[i].flags, SampleFlag::ByHand))
            samples[i].flags |= flagBit(SampleFlag::Jump);
    }
}

} // namespace

SpikeVerdict flagSpikes(std::vector<Sample> &samples, const AnalysisOptions &options,
                        const MeasurementNoise &measurement)
{
    const std::vector<bool> open = openSamples(samples);
    Round round = outlying(samples, open, options);
    MotionNoise searchNoise;
    for (int pass = 0; pass < mostPasses; ++pass) {
        searchNoise = pass == 0 ? firstNoise(samples, open, round, options)
                                : noiseBetweenChanges(samples, open, round, options);
        Round next = searchAll(samples, open, searchNoise, options);
        const bool settled = next.spike == round.spike && next.abrupt == round.abrupt;
        round = std::move(next);
        if (settled)
            break;
    }
    flagFound(samples, round);
    LearntMotion learnt = learnMotion(samples, round, options, measurement);
    const std::size_t used = countUsed(samples);
    flagOutliers(samples, round, learnt);
    nameLimits(samples, options);
    refuseBeyondTask(samples, options, learnt.noise.measurementScale);
    if (countUsed(samples) != used)
        learnt = learnMotion(samples, round, options, measurement);
    return {learnt.noise, learnt.usualDensity, searchNoise, changesOf(learnt, round)};
}

std::vector<MotionChange> flagSpikesKnowing(const SpikeVerdict &known, std::vector<Sample> &samples,
                                            const AnalysisOptions &options)
{
    Round round = searchAll(samples, openSamples(samples), known.searchNoise, options);
    flagFound(samples, round);
    LearntMotion learnt{partedSegments(samples, round, options), known.noise, known.usualDensity};
    adaptToMotion(learnt.segments, known.noise, known.usualDensity);
    flagOutliers(samples, round, learnt);
    nameLimits(samples, options);
    refuseBeyondTask(samples, options, known.noise.measurementScale);
    return changesOf(learnt, round);
}

namespace {

Message outlierWords(HampelSpike spike)
{
    if (spike.byPosition && spike.bySpeed)
        return ODO_TEXT("trajectory.stands_out_in_both", "spike in position and speed");
    return spike.byPosition ? ODO_TEXT("trajectory.stands_out_in_position", "spike in position")
                            : ODO_TEXT("trajectory.stands_out_in_speed", "spike in speed");
}

Message reasonOf(const Sample &sample, const SampleEvidence &evidence, const ProfilePoint &point,
                 HampelSpike isOutlier)
{
    if (hasFlag(sample.flags, SampleFlag::ByHand) && isRejected(sample.flags))
        return ODO_TEXT("trajectory.spike_by_hand", "marked as a spike by hand");
    std::vector<Message> reasons;
    if (hasFlag(sample.flags, SampleFlag::ViewsDisagree)) {
        reasons.push_back(ODO_TEXT("trajectory.views_disagree", "views disagree by %1")(
            quantity(toMillimetres(sample.viewDisagreementM.value_or(0)), 0, "mm")));
        reasons.push_back(hasFlag(sample.flags, SampleFlag::Jump)
                              ? ODO_TEXT("trajectory.no_view_trusted", "none could be trusted")
                              : ODO_TEXT("trajectory.view_left_out", "one left out"));
    } else if (hasFlag(sample.flags, SampleFlag::Jump)) {
        reasons.push_back(point.valid
                              ? ODO_TEXT("trajectory.jump_of", "jump of %1")(quantity(
                                    toMillimetres((*sample.position - point.position).norm()), 0, "mm"))
                              : ODO_TEXT("trajectory.jump", "jump"));
        if (isOutlier.any())
            reasons.push_back(outlierWords(isOutlier));
    }
    if (hasFlag(sample.flags, SampleFlag::SpeedLimit))
        reasons.push_back(ODO_TEXT("trajectory.faster_than_limit", "speed above the limit"));
    if (hasFlag(sample.flags, SampleFlag::AccelerationLimit))
        reasons.push_back(ODO_TEXT("trajectory.harder_than_limit", "acceleration above the limit"));
    if (hasFlag(sample.flags, SampleFlag::LowScore))
        reasons.push_back(evidence.cut
                              ? ODO_TEXT("trajectory.cut_by_edge", "cut by the frame's edge")
                              : ODO_TEXT("trajectory.tracker_unsure", "the tracker was not sure (score %1)")(
                                    quantity(100 * evidence.bestScore, 0, "%")));
    return joined(std::move(reasons), Join::Semicolon);
}

} // namespace

std::vector<Spike> describeSpikes(const FusedTrack &track, const std::vector<ProfilePoint> &points,
                                  Nanoseconds longestGap)
{
    constexpr SampleFlags spikeFlags = flagBit(SampleFlag::Jump) | flagBit(SampleFlag::SpeedLimit) |
                                       flagBit(SampleFlag::AccelerationLimit) |
                                       flagBit(SampleFlag::ViewsDisagree) | flagBit(SampleFlag::LowScore);
    if (std::ranges::none_of(track.samples,
                             [](const Sample &sample) { return (sample.flags & spikeFlags) != 0; }))
        return {};
    std::vector<HampelSpike> isOutlier(track.samples.size());
    const auto isMeasured = [](const Sample &sample) { return sample.position.has_value(); };
    for (const TrackSegment &segment : cutIntoSegments(track.samples, longestGap, isMeasured)) {
        const auto found = hampelSpikes(segment.nodes);
        std::copy(found.begin(), found.end(), isOutlier.begin() + static_cast<std::ptrdiff_t>(segment.first));
    }
    std::vector<Spike> spikes;
    for (std::size_t i = 0; i < track.samples.size(); ++i) {
        const Sample &sample = track.samples[i];
        const SampleFlags against = sample.flags & spikeFlags;
        const SampleEvidence &evidence = track.evidence[i];
        if (against == 0 || (against == flagBit(SampleFlag::LowScore) && evidence.partlySeen) ||
            (against == flagBit(SampleFlag::ViewsDisagree) && evidence.isContradicted))
            continue;
        spikes.push_back({static_cast<std::int64_t>(i), sample.time, sample.flags,
                          reasonOf(sample, evidence, points[i], isOutlier[i])});
    }
    return spikes;
}

} // namespace odo
