// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/spike_flags.h"

#include "core/trajectory/hampel.h"
#include "core/trajectory/spike_search.h"
#include "core/trajectory/track_segments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace odo {

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
    std::vector<bool> abrupt;
};

Round searchAll(const std::vector<Sample> &samples, const std::vector<bool> &open, MotionNoise noise,
                const AnalysisOptions &options)
{
    noise.jerkDensity = std::clamp(noise.jerkDensity, leastJerkDensity, largestJerkDensity);
    noise.measurementScale = std::max(noise.measurementScale, leastScale);
    Round round{std::vector<bool>(samples.size()), std::vector<bool>(samples.size())};
    const auto isOpen = [&](const Sample &sample) {
        return open[static_cast<std::size_t>(&sample - samples.data())];
    };
    for (const TrackSegment &segment : cutIntoSegments(samples, options.longestBridgedGap, isOpen)) {
        const SpikeSearch found = searchSpikes(segment.nodes, noise, options.maxSpeedMps);
        for (std::size_t i = 0; i < segment.nodes.size(); ++i) {
            round.spike[segment.first + i] = found.spike[i];
            round.abrupt[segment.first + i] = found.abrupt[i];
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

/// A first guess of which samples stand out, by Hampel's identifier on position and speed. Only the first
/// estimate of the noise leaves them out; whether they are spikes is for the search to say.
Round standingOut(const std::vector<Sample> &samples, const std::vector<bool> &open,
                  const AnalysisOptions &options)
{
    Round round{std::vector<bool>(samples.size()), std::vector<bool>(samples.size())};
    const auto isOpen = [&](const Sample &sample) {
        return open[static_cast<std::size_t>(&sample - samples.data())];
    };
    for (const TrackSegment &segment : cutIntoSegments(samples, options.longestBridgedGap, isOpen)) {
        const auto outliers = hampelSpikes(segment.nodes);
        for (std::size_t i = 0; i < outliers.size(); ++i)
            round.spike[segment.first + i] = outliers[i];
    }
    return round;
}

/// Adds to refused samples which physical limit they would break.
void nameLimits(std::vector<Sample> &samples, const AnalysisOptions &options)
{
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!samples[i].position || !hasFlag(samples[i].flags, SampleFlag::Jump) ||
            hasFlag(samples[i].flags, SampleFlag::ByHand))
            continue;
        // The nearest used neighbours stand for the motion.
        std::optional<std::size_t> before, behind;
        for (std::size_t j = i; j-- > 0 && !before;) {
            if (samples[j].position && !isRejected(samples[j].flags))
                before = j;
        }
        for (std::size_t j = i + 1; j < samples.size() && !behind; ++j) {
            if (samples[j].position && !isRejected(samples[j].flags))
                behind = j;
        }
        if (!before || !behind)
            continue;
        const double in = toSeconds(samples[i].time - samples[*before].time);
        const double out = toSeconds(samples[*behind].time - samples[i].time);
        const Eigen::Vector2d speedIn = (*samples[i].position - *samples[*before].position) / in;
        const Eigen::Vector2d speedOut = (*samples[*behind].position - *samples[i].position) / out;
        if (std::min(speedIn.norm(), speedOut.norm()) > options.maxSpeedMps)
            samples[i].flags |= flagBit(SampleFlag::SpeedLimit);
        if ((speedOut - speedIn).norm() > options.maxAccelMps2 * (in + out) / 2)
            samples[i].flags |= flagBit(SampleFlag::AccelerationLimit);
    }
}

} // namespace

MotionNoise flagSpikes(std::vector<Sample> &samples, const AnalysisOptions &options,
                       const MeasurementNoise &measurement)
{
    // Samples refused for another reason before are not judged again.
    std::vector<bool> open(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        open[i] = samples[i].position && !isRejected(samples[i].flags);
    Round round = standingOut(samples, open, options);
    for (int pass = 0; pass < mostPasses; ++pass) {
        const MotionNoise noise = pass == 0 ? firstNoise(samples, open, round, options)
                                            : noiseBetweenChanges(samples, open, round, options);
        Round next = searchAll(samples, open, noise, options);
        const bool settled = next.spike == round.spike && next.abrupt == round.abrupt;
        round = std::move(next);
        if (settled)
            break;
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (round.spike[i] && !hasFlag(samples[i].flags, SampleFlag::ByHand))
            samples[i].flags |= flagBit(SampleFlag::Jump);
    }
    nameLimits(samples, options);
    return estimateMotionNoise(nodesOf(cutIntoSegments(samples, options.longestBridgedGap)), false, measurement);
}

namespace {

std::string words(const char *format, double figure)
{
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), format, figure);
    return text.data();
}

std::string reasonOf(const Sample &sample, const SampleEvidence &evidence, const ProfilePoint &point)
{
    std::string reason;
    const auto add = [&](const std::string &more) { reason += (reason.empty() ? "" : "; ") + more; };
    if (hasFlag(sample.flags, SampleFlag::ByHand) && isRejected(sample.flags))
        return "called a spike by hand";
    if (hasFlag(sample.flags, SampleFlag::ViewsDisagree)) {
        add(words("views disagree by %.0f mm", toMillimetres(sample.viewDisagreementM.value_or(0))));
        add(hasFlag(sample.flags, SampleFlag::Jump) ? "none could be trusted" : "one left out");
    } else if (hasFlag(sample.flags, SampleFlag::Jump)) {
        add(point.valid ? words("jump of %.0f mm", toMillimetres((*sample.position - point.position).norm()))
                        : std::string("jump"));
    }
    if (hasFlag(sample.flags, SampleFlag::SpeedLimit))
        add("faster than the limit");
    if (hasFlag(sample.flags, SampleFlag::AccelerationLimit))
        add("harder than the limit of acceleration");
    if (hasFlag(sample.flags, SampleFlag::LowScore))
        add(evidence.cut ? std::string("cut by the picture's edge")
                         : words("the tracker was not sure (score %.0f %%)", 100 * evidence.bestScore));
    return reason;
}

} // namespace

std::vector<Spike> describeSpikes(const FusedTrack &track, const std::vector<ProfilePoint> &points)
{
    constexpr SampleFlags spikeFlags = flagBit(SampleFlag::Jump) | flagBit(SampleFlag::SpeedLimit) |
                                       flagBit(SampleFlag::AccelerationLimit) |
                                       flagBit(SampleFlag::ViewsDisagree) | flagBit(SampleFlag::LowScore);
    std::vector<Spike> spikes;
    for (std::size_t i = 0; i < track.samples.size(); ++i) {
        const Sample &sample = track.samples[i];
        if ((sample.flags & spikeFlags) == 0)
            continue;
        spikes.push_back({static_cast<std::int64_t>(i), sample.time, sample.flags,
                          reasonOf(sample, track.evidence[i], points[i])});
    }
    return spikes;
}

} // namespace odo
