// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/axis_track.h"

#include "core/trajectory/axis_path.h"
#include "core/trajectory/kalman_smoother.h"
#include "core/trajectory/view_clock.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double sureScore = 0.3;
constexpr double longestGapS = 1.0; // an axis that was not seen for longer may be any
constexpr double commonShare = 0.5; // of an outline's doubt that all frames share

/// One observation in the order of time, with the axis that its outline shows.
struct AxisNode
{
    std::size_t view = 0, observation = 0;
    std::optional<OutlineMisfit> misfit;
    TrackNode node;
    double sigmaRad = 0;
};

std::vector<AxisNode> look(const std::vector<ViewTrack> &views, const SolidShape &shape)
{
    std::vector<AxisNode> nodes;
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t i = 0; i < views[v].observations.size(); ++i) {
            const Observation &observation = views[v].observations[i];
            AxisNode one{v, i, {}, {toSeconds(timeOf(views[v], observation)), false, {}, {}}, 0};
            const bool clear = views[v].floorView && observation.found && !observation.duplicateFrame &&
                               !observation.touchesBorder && observation.score >= sureScore;
            if (clear)
                one.misfit = OutlineMisfit::create(*views[v].floorView, shape, outlineMoments(observation));
            nodes.push_back(one);
        }
    }
    std::stable_sort(nodes.begin(), nodes.end(),
                     [](const AxisNode &a, const AxisNode &b) { return a.node.timeS < b.node.timeS; });
    return nodes;
}

std::optional<AxisCosts> costsOf(const OutlineMisfit &misfit)
{
    AxisCosts costs;
    for (std::size_t bin = 0; bin < axisBins; ++bin) {
        const auto residual = misfit.at(angleOfBin(bin));
        if (!residual)
            return std::nullopt;
        costs[bin] = static_cast<float>(residual->squaredNorm());
    }
    return costs;
}

void measure(AxisNode &one, const BodyAxis &axis)
{
    one.node.measured = true;
    one.node.position = {std::cos(2 * axis.angleRad), std::sin(2 * axis.angleRad)};
    one.node.covariance = Eigen::Matrix2d::Identity() * (4 * axis.sigmaRad * axis.sigmaRad);
    one.sigmaRad = axis.sigmaRad;
}

/// Gives each node the axis near the likeliest turning.
void measureAxes(std::vector<AxisNode> &nodes)
{
    std::vector<AxisEvidence> evidence;
    for (const AxisNode &one : nodes)
        evidence.push_back({one.node.timeS, one.misfit ? costsOf(*one.misfit) : std::nullopt});
    const std::vector<std::size_t> path = likeliestPath(evidence);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!evidence[i].costs)
            continue;
        const auto axis = axisAbout(*nodes[i].misfit, angleOfBin(path[i]));
        if (!axis || axis->sigmaRad > unknownAxisSigmaRad)
            continue;
        measure(nodes[i], *axis);
    }
}

/// Stretches [first, end) from a measured node to a measured one without a long gap.
std::vector<std::pair<std::size_t, std::size_t>> stretches(const std::vector<AxisNode> &nodes)
{
    std::vector<std::pair<std::size_t, std::size_t>> found;
    double lastS = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].node.measured)
            continue;
        if (found.empty() || nodes[i].node.timeS - lastS > longestGapS)
            found.emplace_back(i, i + 1);
        found.back().second = i + 1;
        lastS = nodes[i].node.timeS;
    }
    return found;
}

BodyAxis axisOf(const MotionEstimate &estimate, double outlineSigmaRad)
{
    const Eigen::Vector2d doubled = estimate.position();
    const Eigen::Vector2d across(-doubled.y(), doubled.x());
    const double length = doubled.norm();
    if (length < 0.3)
        return {0, 2 * unknownAxisSigmaRad};
    const Eigen::Matrix2d covariance = estimate.covariance.topLeftCorner<2, 2>();
    const double variance = across.dot(covariance * across) / std::pow(length, 4) / 4;
    return {std::atan2(doubled.y(), doubled.x()) / 2,
            std::hypot(std::sqrt(std::max(0.0, variance)), commonShare * outlineSigmaRad)};
}

/// The axis at every node's time, smoothed; with σ above unknownAxisSigmaRad where there is none.
std::vector<BodyAxis> smooth(const std::vector<AxisNode> &nodes)
{
    std::vector<BodyAxis> axes(nodes.size(), BodyAxis{0, 2 * unknownAxisSigmaRad});
    std::vector<std::vector<TrackNode>> segments;
    const auto parts = stretches(nodes);
    for (const auto &[first, end] : parts) {
        segments.emplace_back();
        for (std::size_t i = first; i < end; ++i)
            segments.back().push_back(nodes[i].node);
    }
    const std::vector<std::span<const TrackNode>> spans(segments.begin(), segments.end());
    const MotionNoise noise = estimateMotionNoise(spans, false);
    for (std::size_t s = 0; s < segments.size(); ++s) {
        const auto estimates = smoothMotion(segments[s], noise);
        double sigmaRad = 0;
        for (std::size_t i = 0; i < estimates.size(); ++i) {
            const AxisNode &one = nodes[parts[s].first + i];
            if (one.node.measured)
                sigmaRad = one.sigmaRad;
            axes[parts[s].first + i] = axisOf(estimates[i], sigmaRad);
        }
    }
    return axes;
}

/// Once the turning is known, the outlines can be asked more finely: each for the fit next to it.
void refineAxes(std::vector<AxisNode> &nodes, const std::vector<BodyAxis> &smoothed)
{
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].node.measured || smoothed[i].sigmaRad > unknownAxisSigmaRad)
            continue;
        const auto axis = axisNear(*nodes[i].misfit, smoothed[i].angleRad);
        if (axis && axis->sigmaRad < unknownAxisSigmaRad &&
            std::abs(axis->angleRad - smoothed[i].angleRad) < 3 * smoothed[i].sigmaRad)
            measure(nodes[i], *axis);
    }
}

} // namespace

std::vector<std::vector<BodyAxis>> trackAxis(const std::vector<ViewTrack> &views, const SolidShape &shape)
{
    std::vector<std::vector<BodyAxis>> axes;
    for (const ViewTrack &view : views)
        axes.emplace_back(view.observations.size(), BodyAxis{0, 2 * unknownAxisSigmaRad});
    if (shape.form == SolidShape::Form::Cylinder)
        return axes;
    std::vector<AxisNode> all = look(views, shape);
    measureAxes(all);
    refineAxes(all, smooth(all));
    const std::vector<BodyAxis> smoothed = smooth(all);
    for (std::size_t i = 0; i < all.size(); ++i)
        axes[all[i].view][all[i].observation] = smoothed[i];
    return axes;
}

} // namespace odo
