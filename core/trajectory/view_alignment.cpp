// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_alignment.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace odo {

namespace {

constexpr double averagedSamples = 10;

/// How far a view lay beside the fused track, and when that was last seen.
struct Offset
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    double weight = 0;
    Nanoseconds time{0};

    void add(const Eigen::Vector2d &residual, Nanoseconds when)
    {
        weight = std::min(weight + 1, averagedSamples);
        mean += (residual - mean) / weight;
        time = when;
    }
};

/// For each sample that the view carries alone: the running offset when it was last joined, in the order of
/// `indices`.
std::vector<std::optional<Offset>> sweep(const std::vector<Sample> &samples,
                                         const std::vector<Sighting> &sightings, std::uint32_t bit,
                                         const std::vector<std::size_t> &indices)
{
    std::vector<std::optional<Offset>> last(samples.size());
    Offset offset;
    for (const std::size_t i : indices) {
        const Sample &sample = samples[i];
        if (!sample.position || (sample.views & bit) == 0)
            continue;
        if (std::popcount(sample.views) > 1 && !isRejected(sample.flags))
            offset.add(sightings[i].place.pointInWorld - *sample.position, sample.time);
        else if (offset.weight > 0)
            last[i] = offset;
    }
    return last;
}

Eigen::Vector2d between(const Offset &before, const Offset &behind, Nanoseconds time)
{
    const double span = toSeconds(behind.time - before.time);
    const double fraction = span > 0 ? std::clamp(toSeconds(time - before.time) / span, 0.0, 1.0) : 0.5;
    return before.mean + fraction * (behind.mean - before.mean);
}

} // namespace

void alignSingleViews(FusedTrack &track, const std::vector<std::vector<Sighting>> &views)
{
    std::vector<Sample> &samples = track.samples;
    std::vector<std::size_t> forward(samples.size());
    for (std::size_t i = 0; i < forward.size(); ++i)
        forward[i] = i;
    const std::vector<std::size_t> backward(forward.rbegin(), forward.rend());
    for (std::size_t v = 0; v < views.size(); ++v) {
        const std::uint32_t bit = 1u << v;
        const auto before = sweep(samples, views[v], bit, forward);
        const auto behind = sweep(samples, views[v], bit, backward);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (samples[i].views != bit)
                continue;
            if (before[i] && behind[i])
                *samples[i].position -= between(*before[i], *behind[i], samples[i].time);
            else if (before[i] || behind[i])
                *samples[i].position -= before[i] ? before[i]->mean : behind[i]->mean;
        }
    }
}

} // namespace odo
