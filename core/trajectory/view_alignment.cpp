// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_alignment.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <map>
#include <optional>

namespace odo {

namespace {

constexpr double averagedSamples = 10;

/// How far a view lay beside the fused track, and when that was last seen.
struct ViewOffset
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

/// The running offset of a view, sample by sample in one direction of time.
class Sweep
{
public:
    Sweep(const std::vector<Sample> &samples, const std::vector<Sighting> &sightings, std::uint32_t bit)
        : m_samples(samples), m_sightings(sightings), m_bit(bit)
    {
    }

    /// Goes on to the next sample; for one that the view carries alone: the offset when it was last joined.
    std::optional<ViewOffset> next(std::size_t i)
    {
        const Sample &sample = m_samples[i];
        if (!sample.position || (sample.views & m_bit) == 0)
            return std::nullopt;
        const bool joined = std::popcount(sample.views) > 1 && !isRejected(sample.flags);
        if (joined)
            m_offset.add(m_sightings[i].place.pointInWorld - *sample.position, sample);
        return !joined && sample.views == m_bit && m_offset.weight > 0 ? std::optional(m_offset) : std::nullopt;
    }

private:
    const std::vector<Sample> &m_samples;
    const std::vector<Sighting> &m_sightings;
    std::uint32_t m_bit;
    ViewOffset m_offset;
};

/// The offset to take from a sample that the view carries alone.
Eigen::Vector2d offsetOf(const Sample &sample, const std::optional<ViewOffset> &before,
                         const std::optional<ViewOffset> &behind, const std::optional<FloorView> &view)
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
    for (std::size_t v = 0; v < sightings.size(); ++v) {
        const std::uint32_t bit = 1u << v;
        std::map<std::size_t, std::optional<ViewOffset>> behind;
        Sweep backward(samples, sightings[v], bit);
        for (std::size_t i = samples.size(); i-- > 0;) {
            if (auto offset = backward.next(i))
                behind.emplace(i, std::move(offset));
        }
        Sweep forward(samples, sightings[v], bit);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const auto before = forward.next(i);
            const auto after = behind.find(i);
            const auto its = after != behind.end() ? after->second : std::nullopt;
            if (before || its)
                *samples[i].position -= offsetOf(samples[i], before, its, views[v].floorView);
        }
    }
}

} // namespace odo
