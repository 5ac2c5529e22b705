// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_alignment.h"

#include <Eigen/LU>
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
    Eigen::Vector2d place = Eigen::Vector2d::Zero();

    void add(const Eigen::Vector2d &residual, const Sample &sample)
    {
        weight = std::min(weight + 1, averagedSamples);
        mean += (residual - mean) / weight;
        time = sample.time;
        place = *sample.position;
    }

    /// What of it is to be expected at another place.
    Eigen::Vector2d at(const Eigen::Vector2d &point, const std::optional<FloorView> &view) const
    {
        const auto there = view ? view->sharedCovariance(place, place, 0) : std::nullopt;
        const auto shared = view ? view->sharedCovariance(point, place, 0) : std::nullopt;
        if (!there || !shared || !(there->determinant() > 0))
            return mean;
        return *shared * there->inverse() * mean;
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
            offset.add(sightings[i].place.pointInWorld - *sample.position, sample);
        else if (offset.weight > 0)
            last[i] = offset;
    }
    return last;
}

/// The offset to take from a sample that the view carries alone.
Eigen::Vector2d offsetOf(const Sample &sample, const std::optional<Offset> &before,
                         const std::optional<Offset> &behind, const std::optional<FloorView> &view)
{
    if (!before || !behind)
        return (before ? *before : *behind).at(*sample.position, view);
    const double span = toSeconds(behind->time - before->time);
    const double fraction = span > 0 ? std::clamp(toSeconds(sample.time - before->time) / span, 0.0, 1.0) : 0.5;
    return (1 - fraction) * before->at(*sample.position, view) + fraction * behind->at(*sample.position, view);
}

} // namespace

void alignSingleViews(FusedTrack &track, const std::vector<std::vector<Sighting>> &sightings,
                      const std::vector<ViewTrack> &views)
{
    std::vector<Sample> &samples = track.samples;
    std::vector<std::size_t> forward(samples.size());
    for (std::size_t i = 0; i < forward.size(); ++i)
        forward[i] = i;
    const std::vector<std::size_t> backward(forward.rbegin(), forward.rend());
    for (std::size_t v = 0; v < sightings.size(); ++v) {
        const std::uint32_t bit = 1u << v;
        const auto before = sweep(samples, sightings[v], bit, forward);
        const auto behind = sweep(samples, sightings[v], bit, backward);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (samples[i].views == bit && (before[i] || behind[i]))
                *samples[i].position -= offsetOf(samples[i], before[i], behind[i], views[v].floorView);
        }
    }
}

} // namespace odo
