// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/motion_levels.h"

#include "core/trajectory/internal/wobble_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace odo {

namespace {

/// Logarithms of the densities that are tried, against that of the whole run: from an even motion to blows.
constexpr std::array<double, 9> decades{-12, -10, -8, -6, -4, -2, 0, 2, 4};
constexpr double dwellS = 1;     // how long one of them holds on average
constexpr std::size_t reach = 2; // steps beside a lively one: a velocity changes by two jerks at least
using Levels = std::array<double, decades.size()>;

/// Of what says nothing.
constexpr double saysNothing = -std::numeric_limits<double>::infinity();

/// −½ of the cost of each measurement's innovation, by the filter of one density. Where the motion breaks its
/// prediction it begins anew: else it would err for as long as it remembers, and a calm stretch behind a blow
/// would seem lively.
template <class Filter>
void addEvidence(std::span<const TrackNode> nodes, const MotionNoise &noise, std::size_t level,
                 std::vector<Levels> &evidence)
{
    constexpr double broken = 30; // of χ² with two degrees of freedom
    Filter filter(noise);
    int taken = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].measured)
            continue;
        filter.predict(nodes[i]);
        if (taken++ > startingInnovations) {
            double logDeterminant = 0;
            const double distance = filter.distanceSquared(nodes[i], &logDeterminant);
            evidence[i][level] = -(distance + logDeterminant) / 2;
            if (distance > broken) {
                filter = Filter(noise);
                filter.predict(nodes[i]);
                taken = 1;
            }
        }
        filter.update(nodes[i]);
    }
}

template <class Filter>
std::vector<Levels> evidenceOf(std::span<const TrackNode> nodes, const MotionNoise &noise,
                               double usualDensity)
{
    Levels nothing;
    nothing.fill(saysNothing);
    std::vector<Levels> evidence(nodes.size(), nothing);
    for (std::size_t level = decades.size(); level-- > 0;) {
        MotionNoise its = noise;
        its.jerkDensity = usualDensity * std::pow(10.0, decades[level]);
        addEvidence<Filter>(nodes, its, level, evidence);
        // while a filter begins, it may be as right as the next livelier one
        for (Levels &one : evidence)
            if (one[level] == saysNothing && level + 1 < decades.size())
                one[level] = one[level + 1];
    }
    return evidence;
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

Levels product(const Levels &a, const Levels &b)
{
    Levels both;
    for (std::size_t level = 0; level < a.size(); ++level)
        both[level] = a[level] * b[level];
    return both;
}

/// What one step on makes of the probabilities: it stays at a level, or begins anew at any.
Levels oneStepOn(const Levels &now, const Levels &anew, double stepS)
{
    const double stays = std::exp(-stepS / dwellS);
    Levels next;
    for (std::size_t level = 0; level < now.size(); ++level)
        next[level] = stays * now[level] + (1 - stays) * anew[level];
    return next;
}

/// A segment in one direction: how long each step takes, and how likely it is at each level.
struct Way
{
    std::vector<double> stepsS;
    std::vector<Levels> likely;
};

Way wayThrough(std::span<const TrackNode> nodes, const MotionNoise &noise, double usualDensity)
{
    Way way;
    way.stepsS.resize(nodes.size());
    for (std::size_t i = 1; i < nodes.size(); ++i)
        way.stepsS[i] = std::abs(nodes[i].timeS - nodes[i - 1].timeS);
    way.likely = noise.wobbleM > 0 ? evidenceOf<WobbleFilter>(nodes, noise, usualDensity)
                                   : evidenceOf<MotionFilter>(nodes, noise, usualDensity);
    std::ranges::transform(way.likely, way.likely.begin(), likelihoods);
    return way;
}

/// The probabilities of the levels at each step but the first, by all evidence (forward–backward algorithm).
std::vector<Levels> posteriors(const Way &way, const Levels &prior)
{
    const std::size_t count = way.likely.size();
    std::vector<Levels> found(count, prior);
    for (std::size_t i = 1; i < count; ++i)
        found[i] = normalised(product(oneStepOn(found[i - 1], prior, way.stepsS[i]), way.likely[i]));
    Levels behind;
    behind.fill(1);
    for (std::size_t i = count; i-- > 1;) {
        const Levels here = product(way.likely[i], behind);
        found[i] = normalised(product(found[i], behind));
        Levels anew;
        anew.fill(std::inner_product(here.begin(), here.end(), prior.begin(), 0.0));
        behind = normalised(oneStepOn(here, anew, way.stepsS[i]));
    }
    return found;
}

/// How much of the run is at each level, by the run itself (Baum and Welch's re-estimation). Beforehand each
/// is as likely, with the weight of one dwell in all.
Levels shareOfLevels(const std::vector<Way> &ways)
{
    constexpr int rounds = 6;
    Levels share;
    share.fill(1.0 / decades.size());
    for (int round = 0; round < rounds; ++round) {
        Levels sum;
        sum.fill(1.0 / decades.size());
        for (const Way &way : ways) {
            const std::vector<Levels> found = posteriors(way, share);
            for (std::size_t i = 1; i < found.size(); ++i)
                for (std::size_t level = 0; level < sum.size(); ++level)
                    sum[level] += found[i][level] * std::min(way.stepsS[i], dwellS) / dwellS;
        }
        share = normalised(sum);
    }
    return share;
}

/// The decade of each step. Livelier than usual in the run it is not: what seems to be is a blow, which is
/// known by itself, or rather a fault of the measurement.
std::vector<double> decadesOf(const Way &way, const Levels &prior)
{
    const std::vector<Levels> found = posteriors(way, prior);
    std::vector<double> means(found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        means[i] = std::min(std::inner_product(found[i].begin(), found[i].end(), decades.begin(), 0.0), 0.0);
    return means;
}

void setLiveliness(std::span<TrackNode> nodes, const std::vector<double> &forwards,
                   const std::vector<double> &backwards)
{
    std::vector<double> livelier(nodes.size());
    for (std::size_t i = 1; i < nodes.size(); ++i)
        livelier[i] = std::max(forwards[i], backwards[nodes.size() - i]);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const auto first = livelier.begin() + std::ptrdiff_t(i > reach ? i - reach : 1),
                   end = livelier.begin() + std::ptrdiff_t(std::min(i + reach + 1, nodes.size()));
        nodes[i].liveliness = std::pow(10.0, *std::max_element(first, end));
    }
}

} // namespace

void adaptToMotion(std::vector<TrackSegment> &segments, const MotionNoise &noise, double usualDensity)
{
    std::vector<Way> ways; // of each segment forwards and backwards
    for (TrackSegment &segment : segments) {
        for (TrackNode &node : segment.nodes)
            node.liveliness = 1;
        ways.push_back(wayThrough(segment.nodes, noise, usualDensity));
        ways.push_back(wayThrough(reversed(segment.nodes), noise, usualDensity));
    }
    const Levels prior = shareOfLevels(ways);
    for (std::size_t i = 0; i < segments.size(); ++i)
        setLiveliness(segments[i].nodes, decadesOf(ways[2 * i], prior), decadesOf(ways[2 * i + 1], prior));
}

} // namespace odo
