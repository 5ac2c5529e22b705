// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/motion_noise.h"

#include "core/base/percentile.h"
#include "core/trajectory/internal/wobble_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace odo {

namespace {

/// Twice the negative log likelihood and the scale that minimises it, for a ratio of jerk density to scale.
struct Likelihood
{
    double cost = 0;
    double scale = 1;
};

constexpr std::size_t blockLength = 500, mostSamples = 20000, mostForWobble = 8000;

struct Sums
{
    double distances = 0, logDeterminants = 0, count = 0;
};

template <class Filter>
void addInnovations(std::span<const TrackNode> track, const MotionNoise &noise, bool robust, Sums &sums)
{
    Filter filter(noise);
    int taken = 0;
    for (const TrackNode &node : track) {
        if (!node.measured)
            continue;
        filter.predict(node);
        double distance = 0, logDeterminant = 0;
        if (filter.started())
            distance = filter.distanceSquared(node, &logDeterminant);
        const bool refused = robust && distance > refusalGate;
        if (taken > startingInnovations) {
            sums.distances += refused ? refusalGate : distance;
            sums.logDeterminants += logDeterminant;
            sums.count += 1;
        }
        if (!refused)
            filter.update(node);
        ++taken;
    }
}

/// noise: at a scale of 1.
Likelihood likelihood(std::span<const std::span<const TrackNode>> blocks, const MotionNoise &noise,
                      bool robust, double trust)
{
    Sums sums;
    for (const auto &block : blocks) {
        if (noise.wobbleM > 0)
            addInnovations<WobbleFilter>(block, noise, robust, sums);
        else
            addInnovations<MotionFilter>(block, noise, robust, sums);
    }
    if (robust)
        return {sums.logDeterminants + sums.distances, 1};
    const double weight = 2 * (sums.count + trust);
    const double scale = (sums.distances + 2 * trust) / weight;
    return {sums.logDeterminants + weight * std::log(scale), scale};
}

/// Long tracks are represented by evenly spread blocks.
std::vector<std::span<const TrackNode>> chooseBlocks(const std::vector<std::span<const TrackNode>> &segments,
                                                     std::size_t most)
{
    std::size_t total = 0;
    for (const auto &segment : segments)
        total += segment.size();
    const std::size_t stride = total / most + 1;
    std::vector<std::span<const TrackNode>> blocks;
    for (const auto &all : segments) {
        if (stride == 1) {
            blocks.push_back(all);
            continue;
        }
        for (std::size_t begin = 0; begin < all.size(); begin += blockLength * stride)
            blocks.push_back(all.subspan(begin, std::min(blockLength, all.size() - begin)));
    }
    return blocks;
}

/// Where between two places a function of one minimum is lowest (golden section).
double lowestBetween(double left, double right, const std::function<double(double)> &costAt)
{
    constexpr double golden = 0.6180339887498949, closeEnough = 0.03;
    double inner = right - golden * (right - left), outer = left + golden * (right - left);
    double innerCost = costAt(inner), outerCost = costAt(outer);
    while (right - left > closeEnough) {
        if (innerCost < outerCost) {
            right = outer;
            outer = inner;
            outerCost = innerCost;
            inner = right - golden * (right - left);
            innerCost = costAt(inner);
        } else {
            left = inner;
            inner = outer;
            innerCost = outerCost;
            outer = left + golden * (right - left);
            outerCost = costAt(outer);
        }
    }
    return (left + right) / 2;
}

} // namespace

MotionNoise estimateMotionNoise(const std::vector<std::span<const TrackNode>> &segments, bool robust,
                                const MeasurementNoise &measurement)
{
    const auto blocks = chooseBlocks(segments, mostSamples);
    const auto noiseAt = [&](double exponent) {
        return MotionNoise{std::pow(10.0, exponent), measurement.scale,   measurement.slowShare,
                           measurement.slowLengthM,  measurement.wobbleM, measurement.wobbleRate,
                           measurement.wobbleOrder};
    };
    const auto costAt = [&](double exponent) {
        return likelihood(blocks, noiseAt(exponent), robust, measurement.trust).cost;
    };
    constexpr double lowest = -5, highest = 6;
    double best = lowest, bestCost = costAt(lowest);
    for (double exponent = lowest + 1; exponent <= highest; ++exponent) {
        if (const double cost = costAt(exponent); cost < bestCost) {
            best = exponent;
            bestCost = cost;
        }
    }
    const double exponent = lowestBetween(std::max(lowest, best - 1), std::min(highest, best + 1), costAt);
    MotionNoise noise = noiseAt(exponent);
    const double scale = likelihood(blocks, noise, robust, measurement.trust).scale;
    noise.jerkDensity *= scale;
    noise.measurementScale *= scale;
    noise.wobbleM *= std::sqrt(scale);
    return noise;
}

namespace {

/// What a wobble of one order may be. A smooth one that is slower or wider would be the robot that sways;
/// steps of a drift are none that a robot can drive.
struct WobbleKind
{
    int order = 2;
    double slowest = 6, fastest = 200; ///< 1/s
    double widestM = 0.003;
};
constexpr WobbleKind smoothWobble, drift{1, 0.1, 60, 0.3};

/// Finds the jerk density and a wobble of one kind that make a track likeliest.
class WobbleSearch
{
public:
    WobbleSearch(const std::vector<std::span<const TrackNode>> &blocks, const MotionNoise &still,
                 const WobbleKind &kind, double trust)
        : m_blocks(blocks), m_still(still), m_kind(kind), m_trust(trust)
    {
    }

    double costOf(const MotionNoise &noise) const { return likelihood(m_blocks, noise, false, m_trust).cost; }

    /// strength: log10 of σ λ^(order − ½), by which alone fast changes go, so the rate is found apart from
    /// it. Of a smooth wobble it is where the search begins, for the independent part stays as it was; the
    /// steps of a drift are known, and how small the independent part is beside them is found.
    MotionNoise likeliest(double jerkExponent, double strength, double rate)
    {
        constexpr int sweeps = 4;
        m_strength = strength;
        m_found = {jerkExponent, m_kind.order == 1 ? std::log10(m_still.measurementScale) - 1 : strength,
                   std::log10(rate)};
        for (int sweep = 0; sweep < sweeps; ++sweep)
            for (std::size_t i = 0; i < m_found.size(); ++i)
                improve(i);
        return noiseOf(m_found);
    }

    /// As slow, and for the same steps as wide, as the track still lets the drift be: how wide it is in the
    /// end shows only in a track that lasts many times as long.
    MotionNoise widestLikely(const MotionNoise &best, double slowest) const
    {
        constexpr double unlikely = 6.6; // of twice the log likelihood: χ² with one degree of freedom, 99 %
        constexpr double factor = 1.5;
        const double most = costOf(best) + unlikely;
        MotionNoise widest = best, next = best;
        while (next.wobbleRate > factor * slowest) {
            next.wobbleRate /= factor;
            next.wobbleM *= std::sqrt(factor);
            if (costOf(next) > most)
                break;
            widest = next;
        }
        return widest;
    }

private:
    MotionNoise noiseOf(const std::array<double, 3> &x) const
    {
        const bool drifts = m_kind.order == 1;
        MotionNoise noise = m_still;
        noise.jerkDensity = std::pow(10, x[0]);
        noise.wobbleRate = std::pow(10, x[2]);
        noise.wobbleOrder = m_kind.order;
        noise.wobbleM = std::min(m_kind.widestM,
                                 std::pow(10, (drifts ? m_strength : x[1]) - (m_kind.order - 0.5) * x[2]));
        if (drifts)
            noise.measurementScale = std::pow(10, x[1]);
        return noise;
    }

    void improve(std::size_t i)
    {
        const std::array<double, 3> lowest{-6, -9, std::log10(m_kind.slowest)},
            highest{6, 9, std::log10(m_kind.fastest)};
        const double from = std::max(lowest[i], m_found[i] - 1), to = std::min(highest[i], m_found[i] + 1);
        m_found[i] = lowestBetween(std::min(from, to), to, [&](double value) {
            auto changed = m_found;
            changed[i] = value;
            return costOf(noiseOf(changed));
        });
    }

    const std::vector<std::span<const TrackNode>> &m_blocks;
    const MotionNoise &m_still;
    const WobbleKind &m_kind;
    const double m_trust;
    double m_strength = 0;
    std::array<double, 3> m_found{};
};

/// What a track holds for this search.
struct TrackExtent
{
    std::size_t measured = 0;
    double variance = 0;  ///< mean stated one of a coordinate, m²
    double durationS = 0; ///< of the longest block
    double stepM = 0;     ///< σ of the independent steps a second that its third differences would come of
};

TrackExtent extentOf(const std::vector<std::span<const TrackNode>> &blocks)
{
    constexpr double stepsInThirdDifference = 6; // 1 + 4 + 1: the variance of its three steps' weights
    TrackExtent extent;
    std::vector<double> squares;
    for (const auto &block : blocks) {
        for (std::size_t i = 0; i < block.size(); ++i) {
            extent.measured += block[i].measured;
            extent.variance += block[i].measured ? block[i].covariance.trace() / 2 : 0;
            if (i < 3 || !block[i].measured || !block[i - 1].measured || !block[i - 2].measured ||
                !block[i - 3].measured)
                continue;
            const Eigen::Vector2d third = block[i].position - block[i - 3].position -
                                          3 * (block[i - 1].position - block[i - 2].position);
            squares.push_back(third.squaredNorm() / stepsInThirdDifference /
                              (block[i].timeS - block[i - 3].timeS) * 3);
        }
        if (!block.empty())
            extent.durationS = std::max(extent.durationS, block.back().timeS - block.front().timeS);
    }
    extent.variance /= std::max(1.0, double(extent.measured));
    constexpr double medianOfChi2 = 1.386; // of two degrees of freedom
    if (!squares.empty())
        extent.stepM = std::sqrt(upperMedian(std::move(squares)) / medianOfChi2);
    return extent;
}

} // namespace

MeasurementNoise withWobble(const std::vector<std::span<const TrackNode>> &segments,
                            const MeasurementNoise &measurement, const MotionNoise &still)
{
    constexpr std::size_t fewest = 200;
    constexpr double decisive = 50; // of twice the log likelihood, for two more parameters
    const auto blocks = chooseBlocks(segments, mostForWobble);
    const TrackExtent extent = extentOf(blocks);
    if (extent.measured < fewest || !(extent.stepM > 0))
        return measurement;
    const double own = std::sqrt(still.measurementScale * extent.variance);
    WobbleSearch smooth(blocks, still, smoothWobble, measurement.trust),
        drifting(blocks, still, drift, measurement.trust);
    const double still3 = std::log10(still.jerkDensity) - 3;
    MotionNoise wobbling = smooth.likeliest(still3, std::log10(2 * own) + 1.5 * std::log10(20), 20);
    const MotionNoise drifted =
        drifting.likeliest(std::min(0.0, still3), std::log10(extent.stepM / std::sqrt(2.0)), 2);
    if (drifting.costOf(drifted) < smooth.costOf(wobbling))
        wobbling = drifting.widestLikely(drifted, 1 / extent.durationS);
    if (!(smooth.costOf(still) - smooth.costOf(wobbling) > decisive))
        return measurement;
    const double scale = likelihood(blocks, wobbling, false, measurement.trust).scale;
    MeasurementNoise result = measurement;
    result.scale = wobbling.measurementScale * scale;
    result.wobbleM = wobbling.wobbleM * std::sqrt(scale);
    result.wobbleRate = wobbling.wobbleRate;
    result.wobbleOrder = wobbling.wobbleOrder;
    return result;
}

} // namespace odo
