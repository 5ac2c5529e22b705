// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/motion_noise.h"

#include "core/trajectory/internal/wobble_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace odo {

namespace {

/// Twice the negative log likelihood and the scale that minimises it, for a ratio of jerk density to scale.
struct Likelihood
{
    double cost = 0;
    double scale = 1;
};

constexpr int startingInnovations = 2; // velocity and acceleration: still all ignorance, no information
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

namespace {

/// Logarithms of the densities that are tried: from an even motion to blows.
constexpr std::array<double, 10> decades{-13, -11, -9, -7, -5, -3, -1, 1, 3, 5};
constexpr double priorPerDecade = 0.85; // how likely they are beforehand, away from that of the whole run
constexpr double dwellS = 1;            // how long one of them holds on average
constexpr std::size_t reach = 2;        // steps beside a lively one: a velocity changes by two jerks at least
using Levels = std::array<double, decades.size()>;

/// Of what says nothing.
constexpr double saysNothing = -std::numeric_limits<double>::infinity();

/// −½ of the cost of each measurement's innovation, by the filter of each density.
template <class Filter>
std::vector<Levels> evidenceOf(std::span<const TrackNode> nodes, const MotionNoise &noise)
{
    Levels nothing;
    nothing.fill(saysNothing);
    std::vector<Levels> evidence(nodes.size(), nothing);
    for (std::size_t level = 0; level < decades.size(); ++level) {
        MotionNoise its = noise;
        its.jerkDensity = std::pow(10.0, decades[level]);
        Filter filter(its);
        int taken = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!nodes[i].measured)
                continue;
            filter.predict(nodes[i]);
            if (taken++ > startingInnovations) {
                double logDeterminant = 0;
                const double distance = filter.distanceSquared(nodes[i], &logDeterminant);
                evidence[i][level] = -(distance + logDeterminant) / 2;
            }
            filter.update(nodes[i]);
        }
    }
    return evidence;
}

std::vector<Levels> evidenceFor(std::span<const TrackNode> nodes, const MotionNoise &noise)
{
    return noise.wobbleM > 0 ? evidenceOf<WobbleFilter>(nodes, noise)
                             : evidenceOf<MotionFilter>(nodes, noise);
}

/// From the end to the beginning.
std::vector<TrackNode> reversed(std::span<const TrackNode> nodes)
{
    std::vector<TrackNode> reversed(nodes.rbegin(), nodes.rend());
    for (std::size_t i = 0; i < reversed.size(); ++i) {
        reversed[i].timeS *= -1;
        reversed[i].travelM *= -1;
        reversed[i].struck = i > 0 && nodes[nodes.size() - i].struck;
    }
    return reversed;
}

/// Probabilities of the levels at one step; they add up to 1.
Levels normalised(Levels levels)
{
    double sum = 0;
    for (const double one : levels)
        sum += one;
    for (double &one : levels)
        one /= sum;
    return levels;
}

Levels priorOfLevels(double usualDensity)
{
    const double usual = std::log10(usualDensity);
    Levels prior;
    for (std::size_t level = 0; level < decades.size(); ++level)
        prior[level] = std::pow(priorPerDecade, std::abs(decades[level] - usual));
    return normalised(prior);
}

/// What one step on makes of the probabilities: it stays at a level, or begins anew at any.
Levels oneStepOn(const Levels &now, const Levels &anew, double stepS)
{
    const double stays = std::exp(-std::abs(stepS) / dwellS);
    Levels next;
    for (std::size_t level = 0; level < now.size(); ++level)
        next[level] = stays * now[level] + (1 - stays) * anew[level];
    return next;
}

Levels product(const Levels &a, const Levels &b)
{
    Levels both;
    for (std::size_t level = 0; level < a.size(); ++level)
        both[level] = a[level] * b[level];
    return both;
}

/// Relative to the likeliest.
Levels likelihoods(const Levels &evidence)
{
    const double best = *std::ranges::max_element(evidence);
    Levels likely;
    for (std::size_t level = 0; level < evidence.size(); ++level)
        likely[level] = best == saysNothing ? 1 : std::exp(evidence[level] - best);
    return likely;
}

/// The decade of each node, by all evidence (forward–backward algorithm): the mean and, because too smooth is
/// worse than too rough, one standard deviation, up to what is usual in the run. Livelier than that it is by
/// one decade at most: what seems livelier is rather a fault of the measurement.
std::vector<double> decadesOf(std::span<const TrackNode> nodes, const MotionNoise &noise, double usualDensity)
{
    std::vector<Levels> likely = evidenceFor(nodes, noise);
    std::ranges::transform(likely, likely.begin(), likelihoods);
    const Levels prior = priorOfLevels(usualDensity);
    const auto stepS = [&](std::size_t i) { return nodes[i].timeS - nodes[i - 1].timeS; };
    std::vector<Levels> before(nodes.size(), prior);
    for (std::size_t i = 1; i < nodes.size(); ++i)
        before[i] = normalised(product(oneStepOn(before[i - 1], prior, stepS(i)), likely[i]));
    std::vector<double> found(nodes.size());
    Levels behind;
    behind.fill(1);
    for (std::size_t i = nodes.size(); i-- > 1;) {
        const Levels probability = normalised(product(before[i], behind));
        double mean = 0, square = 0;
        for (std::size_t level = 0; level < decades.size(); ++level) {
            mean += probability[level] * decades[level];
            square += probability[level] * decades[level] * decades[level];
        }
        const double usual = std::log10(usualDensity),
                     rougher = mean + std::sqrt(std::max(0.0, square - mean * mean));
        found[i] = std::clamp(mean, std::min(rougher, usual), usual + 1);
        const Levels here = product(likely[i], behind);
        Levels anew;
        anew.fill(std::inner_product(here.begin(), here.end(), prior.begin(), 0.0));
        behind = normalised(oneStepOn(here, anew, stepS(i)));
    }
    return found;
}

} // namespace

void adaptToMotion(std::span<TrackNode> segment, const MotionNoise &noise, double usualDensity)
{
    for (TrackNode &node : segment)
        node.liveliness = 1;
    if (segment.size() < 2)
        return;
    const std::vector<double> forwards = decadesOf(segment, noise, usualDensity);
    std::vector<double> backwards = decadesOf(reversed(segment), noise, usualDensity);
    std::ranges::reverse(backwards); // of the step behind each node
    std::vector<double> livelier(segment.size());
    for (std::size_t i = 1; i < segment.size(); ++i)
        livelier[i] = std::max(forwards[i], backwards[i - 1]);
    for (std::size_t i = 1; i < segment.size(); ++i) {
        const auto first = livelier.begin() + std::ptrdiff_t(i > reach ? i - reach : 1),
                   end = livelier.begin() + std::ptrdiff_t(std::min(i + reach + 1, segment.size()));
        segment[i].liveliness = std::pow(10.0, *std::max_element(first, end)) / usualDensity;
    }
}

} // namespace odo
