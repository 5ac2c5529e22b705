// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/view_alignment.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

namespace odo {

namespace {

constexpr double averagedSamples = 10;
constexpr double usualScatter = 2; // of a steady offset, times the variance of single frames

/// How far a view lay beside the fused track, and when that was last seen.
struct ViewOffset
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero(); ///< about the mean
    double frameVariance = 0;                          ///< of single frames as stated, mean
    double weight = 0;
    Nanoseconds time{0};
    Eigen::Vector2d position = Eigen::Vector2d::Zero();

    void add(const FloorPosition &seen, const Sample &sample)
    {
        const Eigen::Vector2d away = seen.pointInWorld - *sample.position - mean;
        weight = std::min(weight + 1, averagedSamples);
        mean += away / weight;
        scatter += (away * away.transpose() - scatter) / weight;
        frameVariance += (seen.pixelCovariance.trace() - frameVariance) / weight;
        if (weight == 1)
            scatter.setZero();
        time = sample.time;
        position = *sample.position;
    }

    /// Of an offset that changes: it will be as far from its mean.
    Eigen::Matrix2d unsteadiness() const
    {
        const double excess = scatter.trace() - usualScatter * frameVariance;
        return excess > 0 ? Eigen::Matrix2d(excess / scatter.trace() * scatter)
                          : Eigen::Matrix2d(Eigen::Matrix2d::Zero());
    }

    /// What of it is expected at another position.
    Eigen::Vector2d at(const Eigen::Vector2d &point, const std::optional<FloorView> &view) const
    {
        const auto there = view ? view->sharedCovariance(position, position, 0) : std::nullopt;
        const auto shared = view ? view->sharedCovariance(point, position, 0) : std::nullopt;
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
            m_offset.add(m_sightings[i].position, sample);
        return !joined && sample.views == m_bit && m_offset.weight > 0 ? std::optional(m_offset)
                                                                       : std::nullopt;
    }

private:
    const std::vector<Sample> &m_samples;
    const std::vector<Sighting> &m_sightings;
    std::uint32_t m_bit;
    ViewOffset m_offset;
};

/// Takes the offset from a sample that the view carries alone.
void align(Sample &sample, const std::optional<ViewOffset> &before, const std::optional<ViewOffset> &behind,
           const std::optional<FloorView> &view)
{
    const Eigen::Vector2d point = *sample.position;
    if (!before || !behind) {
        const ViewOffset &known = before ? *before : *behind;
        *sample.position -= known.at(point, view);
        sample.covariance += known.unsteadiness();
        return;
    }
    const double span = toSeconds(behind->time - before->time);
    const double late = span > 0 ? std::clamp(toSeconds(sample.time - before->time) / span, 0.0, 1.0) : 0.5,
                 early = 1 - late;
    const Eigen::Vector2d first = before->at(point, view), last = behind->at(point, view);
    *sample.position -= early * first + late * last;
    sample.covariance += early * before->unsteadiness() + late * behind->unsteadiness();
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
                align(samples[i], before, its, views[v].floorView);
        }
    }
}

namespace {

constexpr double longestIntervals = 2.5;
constexpr Nanoseconds sameTime = std::chrono::microseconds(50);

/// Interpolates a stretch of sightings [first, last] around the pair (before, before + 1).
class Interpolator
{
public:
    Interpolator(const std::vector<Sighting> &sightings, Nanoseconds longestStep)
        : m_sightings(sightings), m_longestStep(longestStep)
    {
    }

    Sighting at(Nanoseconds time) const
    {
        const auto after =
            std::lower_bound(m_sightings.begin(), m_sightings.end(), time,
                             [](const Sighting &sighting, Nanoseconds t) { return sighting.time < t; });
        const auto next = static_cast<std::size_t>(after - m_sightings.begin());
        for (const std::size_t near : {next, next - 1}) {
            if (near < m_sightings.size() && std::chrono::abs(m_sightings[near].time - time) <= sameTime)
                return stampedAt(m_sightings[near], time);
        }
        Sighting nothing;
        nothing.time = time;
        if (next == m_sightings.size() || next == 0)
            return nothing;
        const auto before = lastSeen(next), behind = firstSeen(next);
        if (!before || !behind || !near(*before, *behind)) {
            nothing.duplicate = m_sightings[next].duplicate || m_sightings[next - 1].duplicate;
            return nothing;
        }
        return between(*before, *behind, time);
    }

private:
    static Sighting stampedAt(Sighting sighting, Nanoseconds time)
    {
        sighting.time = time;
        return sighting;
    }
    /// Index of the last one seen before next; a single frame may be missing between.
    std::optional<std::size_t> lastSeen(std::size_t next) const
    {
        for (std::size_t i = next, left = 2; i > 0 && left > 0; --i, --left) {
            if (m_sightings[i - 1].seen)
                return i - 1;
        }
        return std::nullopt;
    }
    std::optional<std::size_t> firstSeen(std::size_t next) const
    {
        for (std::size_t i = next; i < std::min(next + 2, m_sightings.size()); ++i) {
            if (m_sightings[i].seen)
                return i;
        }
        return std::nullopt;
    }
    bool near(std::size_t a, std::size_t b) const
    {
        const Nanoseconds step = m_sightings[b].time - m_sightings[a].time;
        return step > Nanoseconds{0} && step <= m_longestStep;
    }

    Sighting between(std::size_t before, std::size_t behind, Nanoseconds time) const
    {
        std::vector<std::size_t> nodes{before, behind};
        const bool hasFour = before > 0 && behind + 1 < m_sightings.size() && m_sightings[before - 1].seen &&
                             m_sightings[behind + 1].seen && near(before - 1, before) &&
                             near(behind, behind + 1);
        if (hasFour)
            nodes = {before - 1, before, behind, behind + 1};

        const Sighting &a = m_sightings[before], &b = m_sightings[behind];
        const double fraction = toSeconds(time - a.time) / toSeconds(b.time - a.time);
        const auto blend = [&](const auto &left, const auto &right) {
            return (left * (1 - fraction) + right * fraction).eval();
        };
        Sighting result;
        result.time = time;
        result.seen = true;
        result.cut = a.cut || b.cut;
        result.ofOutline = a.ofOutline && b.ofOutline;
        result.score = std::min(a.score, b.score);
        result.position.pixelCovariance = blend(a.position.pixelCovariance, b.position.pixelCovariance);
        result.position.calibrationCovariance =
            blend(a.position.calibrationCovariance, b.position.calibrationCovariance);
        result.lastingCovariance = blend(a.lastingCovariance, b.lastingCovariance);
        result.position.displacementPerMetreHeight =
            blend(a.position.displacementPerMetreHeight, b.position.displacementPerMetreHeight);
        result.position.pointInWorld.setZero();
        for (const std::size_t i : nodes)
            result.position.pointInWorld += weight(nodes, i, time) * m_sightings[i].position.pointInWorld;
        return result;
    }

    /// Lagrange's weight of node i.
    double weight(const std::vector<std::size_t> &nodes, std::size_t i, Nanoseconds time) const
    {
        double product = 1;
        for (const std::size_t j : nodes) {
            if (j != i)
                product *= toSeconds(time - m_sightings[j].time) /
                           toSeconds(m_sightings[i].time - m_sightings[j].time);
        }
        return product;
    }

    const std::vector<Sighting> &m_sightings;
    Nanoseconds m_longestStep;
};

} // namespace

std::vector<Sighting> sightingsAt(const std::vector<Nanoseconds> &times,
                                  const std::vector<Sighting> &sightings)
{
    const double intervalS = toSeconds(typicalInterval(sightings));
    const Interpolator interpolator(sightings, fromSeconds(intervalS * longestIntervals));
    const double wantedS =
        times.size() < 2 ? intervalS
                         : toSeconds(times.back() - times.front()) / static_cast<double>(times.size() - 1);
    const double widening = wantedS > 0 ? std::max(1.0, intervalS / wantedS) : 1.0;
    // Rates that differ by rounding or a few lost frames are the same rate.
    const double factor = widening > 1.2 ? widening : 1.0;

    std::vector<Sighting> result;
    result.reserve(times.size());
    for (const Nanoseconds time : times) {
        result.push_back(interpolator.at(time));
        if (result.back().seen)
            result.back().position.pixelCovariance *= factor;
    }
    return result;
}

} // namespace odo
