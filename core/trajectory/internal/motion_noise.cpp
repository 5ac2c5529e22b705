// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/motion_noise.h"

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
                           measurement.slowLengthM,  measurement.wobbleM, measurement.wobbleRate};
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

MeasurementNoise withWobble(const std::vector<std::span<const TrackNode>> &segments,
                            const MeasurementNoise &measurement, const MotionNoise &still)
{
    // Slower or wider it would be the robot that sways.
    constexpr double slowest = 6, fastest = 200, widestM = 0.003;
    constexpr std::size_t fewest = 200;
    constexpr double decisive = 50; // of twice the log likelihood, for two more parameters
    constexpr int sweeps = 4;
    const auto blocks = chooseBlocks(segments, mostForWobble);
    std::size_t measured = 0;
    double variance = 0;
    for (const auto &block : blocks) {
        for (const TrackNode &node : block) {
            measured += node.measured;
            variance += node.measured ? node.covariance.trace() / 2 : 0;
        }
    }
    if (measured < fewest)
        return measurement;
    const double own = std::sqrt(still.measurementScale * variance / double(measured));
    std::array<double, 3> found{std::log10(still.jerkDensity) - 3, std::log10(2 * own), std::log10(20.0)};
    const std::array<double, 3> lowest{-6, std::log10(own) - 1, std::log10(slowest)},
        highest{6, std::log10(widestM), std::log10(fastest)};
    const auto noiseOf = [&](const std::array<double, 3> &x) {
        MotionNoise noise = still;
        noise.jerkDensity = std::pow(10, x[0]);
        noise.wobbleM = std::pow(10, x[1]);
        noise.wobbleRate = std::pow(10, x[2]);
        return noise;
    };
    const auto costOf = [&](const MotionNoise &noise) {
        return likelihood(blocks, noise, false, measurement.trust).cost;
    };
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double from = std::max(lowest[i], found[i] - 1), to = std::min(highest[i], found[i] + 1);
            found[i] = lowestBetween(std::min(from, to), to, [&](double value) {
                auto changed = found;
                changed[i] = value;
                return costOf(noiseOf(changed));
            });
        }
    }
    const MotionNoise wobbling = noiseOf(found);
    if (!(costOf(still) - costOf(wobbling) > decisive))
        return measurement;
    MeasurementNoise result = measurement;
    result.wobbleM = wobbling.wobbleM * std::sqrt(measurement.scale / still.measurementScale);
    result.wobbleRate = wobbling.wobbleRate;
    return result;
}

} // namespace odo
