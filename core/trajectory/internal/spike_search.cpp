// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/spike_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace odo {

namespace {

// Prices in units of −2 log likelihood. A single spike costs what an innovation at the gate of 1 : 8000
// would.
constexpr double spikePrice = 16;
constexpr double secondSpikePrice = 12;
constexpr double spikePricePerSecond = 50; // for those that follow the first
constexpr double changePrice = 2;          // beside what the widened covariance costs
constexpr double restartPrice = 70;        // the robot was carried elsewhere
constexpr double startSpeedSigma = 2, startAccelSigma = 10;
constexpr double innovationToSigma = 6; // below it there is nothing to explain
constexpr double innovationToRestart = 30;
constexpr double sigmasOverLimit = 4;
// A tracker that strays longer is unlikely, and a track that is all spikes absurd.
constexpr double longestStrayS = 0.6, dearPricePerSecond = 300;
constexpr double noticedAfterS = 0.02;
constexpr double strayingSpeed = 1.2;  // m/s
constexpr double leastSigmaM = 0.0007; // smaller ones promise more than any image can hold
constexpr double dearestMargin = 60;
constexpr std::size_t mostHypotheses = 32;
constexpr std::size_t mostLearntFrom = 50'000;

enum class Decision : std::uint8_t { Follows = 0, Sped = 1, Spike = 2, Collided = 3 };

/// A decision that is not Follows, linked to the one before it.
struct Remark
{
    std::int64_t before = -1;
    std::size_t node = 0;
    Decision decision = Decision::Follows;
};

struct Hypothesis
{
    MotionFilter filter;
    double cost = 0;
    double outlook = 0;   ///< cost, and what its wide covariance will still have to pay
    double lastTimeS = 0; ///< of the last measurement that was believed
    Eigen::Vector2d lastPosition = Eigen::Vector2d::Zero();
    std::optional<std::size_t> lastSpike = {};         ///< the node before was a spike: which
    std::optional<Eigen::Vector2d> spikeVelocity = {}; ///< from the spike before that one to it
    std::uint64_t recent = 0;                          ///< the last decisions, two bits each
    std::int64_t remark = -1;
};

class Search
{
public:
    Search(std::span<const TrackNode> track, MotionNoise noise, double maxSpeedMps)
        : m_track(track), m_noise(noise), m_maxSpeed(maxSpeedMps)
    {
        learnWhatIsUsual();
    }

    SpikeSearch run()
    {
        Hypothesis beginning{MotionFilter(m_noise)};
        beginning.lastTimeS = m_track.empty() ? 0 : m_track.front().timeS;
        m_alive = {beginning};
        for (std::size_t i = 0; i < m_track.size(); ++i) {
            if (!m_track[i].measured || (m_alive.size() == 1 && followsOn(m_alive.front(), i)))
                continue;
            m_next.clear();
            for (Hypothesis &hypothesis : m_alive)
                continueWith(hypothesis, i);
            prune();
        }
        return result();
    }

private:
    /// A filter that believes everything shows how wide covariances usually are. However smooth a run was
    /// until then, an abrupt change or a gap does not cost more than in an ordinary one. Of a long track its
    /// beginning shows it.
    void learnWhatIsUsual()
    {
        MotionNoise usual = m_noise;
        usual.jerkDensity = std::max(usual.jerkDensity, usualJerkDensity);
        MotionFilter filter(usual);
        std::vector<double> widenings, volumes;
        for (const TrackNode &node : m_track.first(std::min(m_track.size(), mostLearntFrom))) {
            if (!node.measured)
                continue;
            filter.predict(node);
            double logDeterminant = 0;
            if (filter.started()) {
                filter.distanceSquared(node, &logDeterminant);
                widenings.push_back(logDeterminant - measurementLog(node));
            }
            filter.update(node);
            volumes.push_back(filter.logVolume());
        }
        m_usualWidening = median(std::move(widenings));
        m_usualVolume = median(std::move(volumes));
    }
    double measurementLog(const TrackNode &node) const
    {
        return std::log((m_noise.measurementScale * node.covariance).determinant());
    }

    void note(Hypothesis &hypothesis, std::size_t i, Decision decision)
    {
        hypothesis.recent = hypothesis.recent << 2 | static_cast<std::uint64_t>(decision);
        hypothesis.lastSpike = decision == Decision::Spike ? std::optional(i) : std::nullopt;
        if (decision != Decision::Spike)
            hypothesis.spikeVelocity.reset();
        if (decision == Decision::Follows)
            return;
        m_remarks.push_back({hypothesis.remark, i, decision});
        hypothesis.remark = static_cast<std::int64_t>(m_remarks.size()) - 1;
    }

    void believe(Hypothesis hypothesis, std::size_t i, double price, Decision decision)
    {
        hypothesis.cost += price;
        hypothesis.filter.update(m_track[i]);
        hypothesis.lastTimeS = m_track[i].timeS;
        hypothesis.lastPosition = m_track[i].position;
        note(hypothesis, i, decision);
        m_next.push_back(std::move(hypothesis));
    }

    void begin(Hypothesis hypothesis, std::size_t i, double price, Decision decision)
    {
        hypothesis.cost += price;
        hypothesis.filter.restart(m_track[i], startSpeedSigma, startAccelSigma);
        hypothesis.lastTimeS = m_track[i].timeS;
        hypothesis.lastPosition = m_track[i].position;
        note(hypothesis, i, decision);
        m_next.push_back(std::move(hypothesis));
    }

    /// What it costs to call a measurement a spike. A tracker that follows something else goes on from where
    /// it was: at rest, along with the robot, or as it went before; such spikes are not each a new wonder.
    double spikePriceOf(const Hypothesis &hypothesis, std::size_t i) const
    {
        if (!hypothesis.lastSpike || !hypothesis.filter.started())
            return spikePrice;
        const TrackNode &node = m_track[i], &before = m_track[*hypothesis.lastSpike];
        const double step = node.timeS - before.timeS;
        const double sigma = std::sqrt(m_noise.measurementScale * node.covariance.trace());
        const double reach =
            (hypothesis.spikeVelocity ? 0.5 : 1) * strayingSpeed * step + sigmasOverLimit * sigma;
        const Eigen::Vector2d moved = node.position - before.position;
        const bool ofOneRun =
            moved.norm() < reach || (moved - hypothesis.filter.estimate().velocity() * step).norm() < reach ||
            (hypothesis.spikeVelocity && (moved - *hypothesis.spikeVelocity * step).norm() < reach);
        if (!ofOneRun)
            return spikePrice;
        const double rate =
            node.timeS - hypothesis.lastTimeS > longestStrayS ? dearPricePerSecond : spikePricePerSecond;
        return rate * step + (hypothesis.spikeVelocity ? 0 : secondSpikePrice);
    }

    void disbelieve(Hypothesis hypothesis, std::size_t i)
    {
        hypothesis.cost += spikePriceOf(hypothesis, i);
        if (hypothesis.lastSpike)
            hypothesis.spikeVelocity = (m_track[i].position - m_track[*hypothesis.lastSpike].position) /
                                       (m_track[i].timeS - m_track[*hypothesis.lastSpike].timeS);
        note(hypothesis, i, Decision::Spike);
        m_next.push_back(std::move(hypothesis));
    }

    double priceOf(const MotionFilter &filter, const TrackNode &node, double *distance = nullptr) const
    {
        double logDeterminant = 0;
        const double squared = filter.distanceSquared(node, &logDeterminant);
        if (distance)
            *distance = squared;
        return std::max(0.0, squared - innovationToSigma) +
               std::max(0.0, logDeterminant - measurementLog(node) - m_usualWidening);
    }

    bool isTooFast(const Hypothesis &hypothesis, const TrackNode &node) const
    {
        const double sigma = std::sqrt(m_noise.measurementScale * node.covariance.trace());
        return (node.position - hypothesis.lastPosition).norm() - sigmasOverLimit * sigma >
               m_maxSpeed * (node.timeS - hypothesis.lastTimeS);
    }

    /// The usual case, without a copy of anything but the filter: the only explanation continues
    /// unambiguously. Otherwise does nothing.
    bool followsOn(Hypothesis &only, std::size_t i) const
    {
        const TrackNode &node = m_track[i];
        if (!only.filter.started() || only.lastSpike || isTooFast(only, node))
            return false;
        const MotionFilter before = only.filter;
        only.filter.predict(node);
        double distance = 0;
        const double price = priceOf(only.filter, node, &distance);
        if (distance > innovationToSigma) {
            only.filter = before;
            return false;
        }
        only.cost += price;
        only.filter.update(node);
        only.lastTimeS = node.timeS;
        only.lastPosition = node.position;
        only.recent <<= 2; // Decision::Follows
        only.spikeVelocity.reset();
        return true;
    }

    void continueWith(const Hypothesis &hypothesis, std::size_t i)
    {
        const TrackNode &node = m_track[i];
        if (!hypothesis.filter.started()) {
            begin(hypothesis, i, 0, Decision::Follows);
            disbelieve(hypothesis, i);
            return;
        }
        Hypothesis moved = hypothesis;
        moved.filter.predict(node);
        double distance = 0;
        const double price = priceOf(moved.filter, node, &distance);
        const bool possible = !isTooFast(hypothesis, node);
        if (possible)
            believe(moved, i, price, Decision::Follows);
        const bool uncertain = distance > innovationToSigma || hypothesis.lastSpike.has_value() || !possible;
        if (!uncertain)
            return;
        disbelieve(moved, i);
        const double since = node.timeS - hypothesis.lastTimeS;
        if (possible && distance > innovationToSigma) {
            for (const Decision decision : {Decision::Sped, Decision::Collided}) {
                Hypothesis changed = moved;
                // A push shows only some time after it began, a blow at once.
                changed.filter.disturb(0, blowAccelSigmaMps2, std::max(since, noticedAfterS));
                if (decision == Decision::Collided)
                    changed.filter.disturb(blowSpeedSigmaMps, 0, since);
                believe(changed, i, changePrice + priceOf(changed.filter, node), decision);
            }
        }
        if (distance > innovationToRestart)
            begin(moved, i, restartPrice, Decision::Collided);
    }

    /// Of explanations that have agreed of late the cheapest, and in all only those that can still win.
    void prune()
    {
        // The logs of all coming innovations' covariances add up to that of the state's: one that knows less
        // has only not paid yet.
        for (Hypothesis &hypothesis : m_next)
            hypothesis.outlook =
                hypothesis.cost + (hypothesis.filter.started() && m_next.size() > 1
                                       ? std::max(0.0, hypothesis.filter.logVolume() - m_usualVolume)
                                       : 0.0);
        std::sort(m_next.begin(), m_next.end(),
                  [](const Hypothesis &a, const Hypothesis &b) { return a.outlook < b.outlook; });
        m_alive.clear();
        for (Hypothesis &hypothesis : m_next) {
            if (m_alive.size() == mostHypotheses ||
                hypothesis.outlook > m_next.front().outlook + dearestMargin)
                break;
            const auto same = [&](const Hypothesis &kept) {
                constexpr std::uint64_t lastDecisions = 0xfffff; // ten
                return ((kept.recent ^ hypothesis.recent) & lastDecisions) == 0 &&
                       kept.lastTimeS == hypothesis.lastTimeS;
            };
            if (std::none_of(m_alive.begin(), m_alive.end(), same))
                m_alive.push_back(std::move(hypothesis));
        }
    }

    SpikeSearch result() const
    {
        const std::vector<bool> none(m_track.size());
        SpikeSearch found{none, none, none};
        if (m_alive.empty())
            return found;
        for (std::int64_t r = m_alive.front().remark; r >= 0;
             r = m_remarks[static_cast<std::size_t>(r)].before) {
            const Remark &remark = m_remarks[static_cast<std::size_t>(r)];
            (remark.decision == Decision::Spike ? found.spike : found.abrupt)[remark.node] = true;
            found.struck[remark.node] = remark.decision == Decision::Collided;
        }
        return found;
    }

    std::span<const TrackNode> m_track;
    MotionNoise m_noise;
    double m_maxSpeed;
    double m_usualWidening = 0, m_usualVolume = 0;
    std::vector<Hypothesis> m_alive, m_next;
    std::vector<Remark> m_remarks;
};

} // namespace

SpikeSearch searchSpikes(std::span<const TrackNode> track, MotionNoise noise, double maxSpeedMps)
{
    std::vector<TrackNode> widened(track.begin(), track.end());
    for (TrackNode &node : widened)
        node.covariance.diagonal().array() += leastSigmaM * leastSigmaM / noise.measurementScale;
    return Search(widened, noise, maxSpeedMps).run();
}

namespace {

constexpr double toStandardDeviation = 1.4826;

} // namespace

double medianDeviation(const std::vector<double> &values)
{
    const double centre = median(values);
    std::vector<double> deviations;
    deviations.reserve(values.size());
    for (const double value : values)
        deviations.push_back(std::abs(value - centre));
    return toStandardDeviation * median(std::move(deviations));
}

std::vector<bool> hampelOutliers(std::span<const double> values, const HampelSettings &settings)
{
    std::vector<bool> outliers(values.size());
    const auto half = static_cast<std::size_t>(std::max(0, settings.halfWindow));
    std::vector<double> window; // one memory for all of them
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t first = i > half ? i - half : 0, end = std::min(values.size(), i + half + 1);
        window.assign(values.begin() + static_cast<std::ptrdiff_t>(first),
                      values.begin() + static_cast<std::ptrdiff_t>(end));
        const double centre = medianOf(window);
        for (double &value : window)
            value = std::abs(value - centre);
        const double deviation = std::max(settings.leastDeviation, toStandardDeviation * medianOf(window));
        outliers[i] = std::abs(values[i] - centre) > settings.threshold * deviation;
    }
    return outliers;
}

std::vector<HampelSpike> hampelSpikes(std::span<const TrackNode> track)
{
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < track.size(); ++i) {
        if (track[i].measured)
            indices.push_back(i);
    }
    constexpr int halfWindow = 3;
    constexpr double threshold = 5;
    std::vector<HampelSpike> spikes(track.size());
    for (int axis : {0, 1}) {
        std::vector<double> positions, speeds; // speeds[i]: from measurement i to the next
        double sigma = 0, speedSigma = 0;
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const TrackNode &node = track[indices[i]];
            positions.push_back(node.position[axis]);
            sigma = std::max(sigma, std::sqrt(node.covariance(axis, axis)));
            if (i == 0)
                continue;
            const double step = node.timeS - track[indices[i - 1]].timeS;
            speeds.push_back((positions[i] - positions[i - 1]) / step);
            speedSigma = std::max(speedSigma, sigma / step);
        }
        const auto far = hampelOutliers(positions, {halfWindow, threshold, sigma});
        const auto fast = hampelOutliers(speeds, {halfWindow, threshold, speedSigma});
        for (std::size_t i = 0; i < indices.size(); ++i) {
            spikes[indices[i]].byPosition |= far[i];
            spikes[indices[i]].bySpeed |= i > 0 && i < speeds.size() && fast[i - 1] && fast[i];
        }
    }
    return spikes;
}

} // namespace odo
