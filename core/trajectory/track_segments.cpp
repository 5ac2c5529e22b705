// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/track_segments.h"

namespace odo {

std::vector<TrackSegment> cutIntoSegments(const std::vector<Sample> &samples, Nanoseconds longestGap,
                                          const std::function<bool(const Sample &)> &isUsed)
{
    const auto used = [&](const Sample &sample) {
        return sample.position && (isUsed ? isUsed(sample) : !isRejected(sample.flags));
    };
    std::vector<TrackSegment> segments;
    std::size_t last = 0; // index of the last used sample
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!used(samples[i]))
            continue;
        const bool joined = !segments.empty() && samples[i].time - samples[last].time <= longestGap;
        if (!segments.empty() && samples[i].time <= samples[last].time)
            continue;
        if (!joined) {
            segments.push_back({i, {}, 0});
        } else {
            for (std::size_t gap = last + 1; gap < i; ++gap)
                segments.back().nodes.push_back({toSeconds(samples[gap].time), false, {}, {}});
        }
        segments.back().nodes.push_back(
            {toSeconds(samples[i].time), true, *samples[i].position, samples[i].covariance});
        ++segments.back().measured;
        last = i;
    }
    return segments;
}

std::vector<std::span<const TrackNode>> nodesOf(const std::vector<TrackSegment> &segments)
{
    std::vector<std::span<const TrackNode>> nodes;
    for (const TrackSegment &segment : segments)
        nodes.emplace_back(segment.nodes);
    return nodes;
}

} // namespace odo
