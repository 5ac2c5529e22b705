// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/heading_curve.h"

#include "core/trajectory/internal/heading_sequence.h"
#include "core/trajectory/internal/turning_smoother.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

namespace odo {

namespace {

constexpr std::size_t leastHeadings = 5;
constexpr double mostSigmaRad = 0.5;  // beyond it a heading is as good as unknown
constexpr double sharedOverRad = 0.2; // of a turn, over which the outlines' shared error changes

/// Stretches without a long gap, each from one measured heading to another, and their first samples.
struct HeadingSegments
{
    std::vector<std::vector<TurnNode>> nodes;
    std::vector<std::size_t> firsts;
};

double difference(const Sample &from, const Sample &to)
{
    return std::remainder(to.heading->radians - from.heading->radians, 2 * std::numbers::pi);
}

/// Indices of the samples whose heading counts, in order of time (headingsInSequence).
std::vector<std::size_t> usedHeadings(const std::vector<Sample> &samples)
{
    std::vector<std::size_t> used;
    std::vector<TimedHeading> headings;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i].heading && isUsed(samples[i]) &&
            (used.empty() || samples[i].time > samples[used.back()].time)) {
            used.push_back(i);
            headings.push_back({toSeconds(samples[i].time), samples[i].heading->radians});
        }
    }
    std::vector<std::size_t> kept;
    for (const std::size_t k : headingsInSequence(headings))
        kept.push_back(used[k]);
    return kept;
}

HeadingSegments segmentsOf(const std::vector<Sample> &samples, Nanoseconds longestGap)
{
    HeadingSegments segments;
    std::optional<std::size_t> before;
    double heading = 0;
    std::size_t measured = 0;
    const auto dropShort = [&] {
        if (before && measured < leastHeadings) {
            segments.nodes.pop_back();
            segments.firsts.pop_back();
        }
    };
    for (const std::size_t i : usedHeadings(samples)) {
        const Sample &sample = samples[i];
        const bool isNew = !before || sample.time - samples[*before].time > longestGap;
        if (isNew) {
            dropShort();
            segments.nodes.emplace_back();
            segments.firsts.push_back(i);
            measured = 0;
        }
        std::vector<TurnNode> &nodes = segments.nodes.back();
        double lastS = nodes.empty() ? 0 : nodes.back().timeS;
        for (std::size_t between = isNew ? i : *before + 1; between < i; ++between) {
            lastS = std::clamp(toSeconds(samples[between].time), lastS, toSeconds(sample.time));
            nodes.push_back({lastS});
        }
        heading = isNew ? sample.heading->radians : heading + difference(samples[*before], sample);
        nodes.push_back({toSeconds(sample.time), true, heading, std::pow(sample.heading->sigmaRad, 2)});
        ++measured;
        before = i;
    }
    dropShort();
    return segments;
}

std::optional<BodyHeading> bodyOf(const TurnEstimate &estimate, double commonSigmaRad)
{
    if (!(estimate.sigmaRad < mostSigmaRad) || !std::isfinite(estimate.sigmaRateRadps))
        return std::nullopt;
    const double shared =
        commonSigmaRad < unknownFrontSigmaRad ? commonSigmaRad : commonSigmaRad - unknownFrontSigmaRad;
    return BodyHeading{estimate.radians, std::hypot(estimate.sigmaRad, commonSigmaRad), estimate.rateRadps,
                       std::hypot(estimate.sigmaRateRadps, shared * estimate.rateRadps / sharedOverRad)};
}

} // namespace

void smoothHeadings(const std::vector<Sample> &samples, Nanoseconds longestGap,
                    std::vector<ProfilePoint> &points)
{
    const HeadingSegments segments = segmentsOf(samples, longestGap);
    const auto estimates = smoothTurning(segments.nodes);
    for (std::size_t s = 0; s < estimates.size(); ++s) {
        double commonSigmaRad = 0; // in a gap that of the measured heading before it
        for (std::size_t i = 0; i < estimates[s].size(); ++i) {
            const std::size_t at = segments.firsts[s] + i;
            if (segments.nodes[s][i].measured)
                commonSigmaRad = samples[at].heading->commonSigmaRad;
            if (points[at].valid)
                points[at].body = bodyOf(estimates[s][i], commonSigmaRad);
        }
    }
}

double headingScatterRad(const std::vector<Sample> &samples, Nanoseconds longestGap)
{
    constexpr int rounds = 10; // for what is stated counts, too
    HeadingSegments segments = segmentsOf(samples, longestGap);
    if (segments.nodes.empty())
        return 0;
    double variance = 1e-4;
    for (int round = 0; round < rounds; ++round) {
        for (std::vector<TurnNode> &nodes : segments.nodes)
            for (TurnNode &node : nodes)
                node.variance = variance;
        variance *= turnNoiseScale(segments.nodes);
    }
    return std::sqrt(variance);
}

} // namespace odo
