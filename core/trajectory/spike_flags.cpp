// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/spike_flags.h"

#include "core/trajectory/track_segments.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace odo {

namespace {

constexpr int learningUpdates = 3; // until then the velocity is unknown and nothing can be refused
constexpr double longestRefusalS = 0.7;
// The gate must stand a hard start after a long rest, of which the noise estimated from the whole run knows
// little: an acceleration that changes by 2 m/s² within 0.1 s.
constexpr double leastGateJerkDensity = 40;
constexpr int mostPasses = 5;

enum class Verdict { Unknown, Accepted, Refused };

std::vector<Verdict> verdicts(std::span<const TrackNode> track, MotionNoise noise)
{
    MotionFilter filter(noise);
    std::vector<Verdict> result(track.size(), Verdict::Unknown);
    int updates = 0;
    double lastUpdateS = 0;
    for (std::size_t i = 0; i < track.size(); ++i) {
        if (!track[i].measured)
            continue;
        filter.predict(track[i].timeS);
        const bool learning = updates < learningUpdates;
        const bool refused = !learning && filter.distanceSquared(track[i]) > refusalGate;
        if (refused && track[i].timeS - lastUpdateS <= longestRefusalS) {
            result[i] = Verdict::Refused;
            continue;
        }
        if (refused) {
            filter.restart(track[i]);
            updates = 0;
        } else {
            filter.update(track[i]);
        }
        result[i] = learning || refused ? Verdict::Unknown : Verdict::Accepted;
        ++updates;
        lastUpdateS = track[i].timeS;
    }
    return result;
}

} // namespace

std::vector<bool> refusedFromBothSides(std::span<const TrackNode> track, MotionNoise noise)
{
    noise.jerkDensity = std::max(noise.jerkDensity, leastGateJerkDensity);
    std::vector<TrackNode> mirrored(track.rbegin(), track.rend());
    for (TrackNode &node : mirrored)
        node.timeS = -node.timeS;
    const auto forward = verdicts(track, noise);
    const auto backward = verdicts(mirrored, noise);
    std::vector<bool> refused(track.size());
    for (std::size_t i = 0; i < track.size(); ++i) {
        const Verdict past = forward[i], future = backward[track.size() - 1 - i];
        refused[i] = (past == Verdict::Refused && future != Verdict::Accepted) ||
                     (future == Verdict::Refused && past != Verdict::Accepted);
    }
    return refused;
}

namespace {

/// One round of the two-sided gate over all samples that are open to judgement; true when a flag changed.
bool flagJumps(std::vector<Sample> &samples, const std::vector<bool> &open, MotionNoise noise,
               Nanoseconds longestGap)
{
    const auto segments = cutIntoSegments(samples, longestGap, [&](const Sample &sample) {
        return open[static_cast<std::size_t>(&sample - samples.data())];
    });
    bool changed = false;
    for (const TrackSegment &segment : segments) {
        const auto refused = refusedFromBothSides(segment.nodes, noise);
        for (std::size_t i = 0; i < refused.size(); ++i) {
            Sample &sample = samples[segment.first + i];
            if (!segment.nodes[i].measured)
                continue;
            const bool was = hasFlag(sample.flags, SampleFlag::Jump);
            if (was == refused[i])
                continue;
            sample.flags ^= flagBit(SampleFlag::Jump);
            changed = true;
        }
    }
    return changed;
}

/// Lifts flags from samples that lie where the smoothed track without them says they should; true when there
/// are any.
bool restoreFitting(std::vector<Sample> &samples, const std::vector<bool> &open, MotionNoise noise,
                    Nanoseconds longestGap)
{
    bool restored = false;
    for (const TrackSegment &segment : cutIntoSegments(samples, longestGap)) {
        if (segment.measured < 3)
            continue;
        const auto estimates = smoothMotion(segment.nodes, noise);
        for (std::size_t i = 0; i < estimates.size(); ++i) {
            Sample &sample = samples[segment.first + i];
            if (segment.nodes[i].measured || !open[segment.first + i])
                continue;
            const Eigen::Matrix2d s =
                estimates[i].covariance.topLeftCorner<2, 2>() + noise.measurementScale * sample.covariance;
            const Eigen::Vector2d d = *sample.position - estimates[i].position();
            if (d.dot(s.inverse() * d) > refusalGate)
                continue;
            sample.flags &= ~flagBit(SampleFlag::Jump);
            restored = true;
        }
    }
    return restored;
}

/// Adds to refused samples which physical limit they would break.
void nameLimits(std::vector<Sample> &samples, const AnalysisOptions &options)
{
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!samples[i].position || !hasFlag(samples[i].flags, SampleFlag::Jump))
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

MotionNoise flagSpikes(std::vector<Sample> &samples, const AnalysisOptions &options)
{
    // Samples refused for another reason before are not judged again.
    std::vector<bool> open(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        open[i] = samples[i].position && !isRejected(samples[i].flags);
    const auto used = [&] { return cutIntoSegments(samples, options.longestBridgedGap); };
    MotionNoise noise = estimateMotionNoise(nodesOf(used()), true);
    for (int pass = 0; pass < mostPasses; ++pass) {
        const bool changed = flagJumps(samples, open, noise, options.longestBridgedGap);
        if (pass > 0 && !changed)
            break;
        noise = estimateMotionNoise(nodesOf(used()), false);
    }
    if (restoreFitting(samples, open, noise, options.longestBridgedGap))
        noise = estimateMotionNoise(nodesOf(used()), false);
    nameLimits(samples, options);
    return noise;
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
    if (hasFlag(sample.flags, SampleFlag::ViewsDisagree)) {
        add(words("views disagree by %.0f mm", toMillimetres(sample.viewDisagreementM.value_or(0))));
        add(hasFlag(sample.flags, SampleFlag::Jump) ? "none could be trusted"
                                                    : "one left out");
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
