// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/track_segments.h"

#include <algorithm>

namespace odo {

namespace {

constexpr std::size_t nodesAround =
    2; // measured nodes to either side that a step of the way is measured over

/// Fills the way up to each node: over five measured nodes each, so that pixel noise is no way.
void measureTravel(std::vector<TrackNode> &nodes)
{
    std::vector<std::size_t> measured;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].measured)
            measured.push_back(i);
    }
    double travelM = 0;
    for (std::size_t m = 1; m < measured.size(); ++m) {
        const TrackNode &before = nodes[measured[m - std::min(m, nodesAround)]];
        const TrackNode &behind = nodes[measured[std::min(measured.size() - 1, m + nodesAround)]];
        const double speed = (behind.position - before.position).norm() / (behind.timeS - before.timeS);
        const std::size_t from = measured[m - 1], to = measured[m];
        for (std::size_t i = from + 1; i <= to; ++i)
            nodes[i].travelM = travelM + speed * (nodes[i].timeS - nodes[from].timeS);
        travelM = nodes[to].travelM;
    }
}

} // namespace

std::vector<TrackSegment> cutIntoSegments(const std::vector<Sample> &samples, Nanoseconds longestGap,
                                          const std::function<bool(const Sample &)> &isUsed)
{
    const auto used = [&](const Sample &sample) {
        return sample.position && (isUsed ? isUsed(sample) : !isRejected(sample.flags));
    };
    std::vector<bool> taken(samples.size());
    std::vector<std::pair<std::size_t, std::size_t>> stretches; // indices of the first and the last taken
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!used(samples[i]))
            continue;
        const bool first = stretches.empty();
        const Nanoseconds since = first ? Nanoseconds(0) : samples[i].time - samples[stretches.back().second].time;
        if (!first && since <= Nanoseconds(0))
            continue;
        if (first || since > longestGap)
            stretches.emplace_back(i, i);
        stretches.back().second = i;
        taken[i] = true;
    }
    std::vector<TrackSegment> segments;
    for (const auto &[first, last] : stretches) {
        TrackSegment &segment = segments.emplace_back(TrackSegment{first, {}, 0});
        segment.nodes.reserve(last - first + 1);
        for (std::size_t i = first; i <= last; ++i) {
            TrackNode node{toSeconds(samples[i].time)};
            if (taken[i]) {
                node.measured = true;
                node.position = *samples[i].position;
                node.covariance = samples[i].covariance;
                ++segment.measured;
            }
            segment.nodes.push_back(node);
        }
        measureTravel(segment.nodes);
    }
    return segments;
}

void markBlows(std::vector<TrackSegment> &segments, const std::vector<bool> &struck)
{
    if (struck.empty())
        return;
    for (TrackSegment &segment : segments) {
        std::vector<TrackNode> &nodes = segment.nodes;
        for (std::size_t i = nodes.size(); i-- > 1;)
            nodes[i].struck = struck[segment.first + i] ||
                              (i + 1 < nodes.size() && !nodes[i].measured && nodes[i + 1].struck);
    }
}

std::vector<std::span<const TrackNode>> nodesOf(const std::vector<TrackSegment> &segments)
{
    std::vector<std::span<const TrackNode>> nodes;
    for (const TrackSegment &segment : segments)
        nodes.emplace_back(segment.nodes);
    return nodes;
}

} // namespace odo
