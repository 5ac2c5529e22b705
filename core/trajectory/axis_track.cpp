// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/axis_track.h"

#include "core/trajectory/kalman_smoother.h"

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
    TrackNode node;
    double sigmaRad = 0;
};

std::vector<AxisNode> look(const std::vector<ViewTrack> &views, const SolidShape &shape)
{
    std::vector<AxisNode> nodes;
    for (std::size_t v = 0; v < views.size(); ++v) {
        std::optional<double> guess;
        for (std::size_t i = 0; i < views[v].observations.size(); ++i) {
            const Observation &observation = views[v].observations[i];
            AxisNode one{v, i, {toSeconds(observation.time + views[v].startOffset), false, {}, {}}, 0};
            const bool clear = views[v].floorView && observation.found && !observation.duplicateFrame &&
                               !observation.touchesBorder && observation.score >= sureScore;
            const auto axis =
                clear ? axisFromOutline(*views[v].floorView, shape, observation, guess) : std::nullopt;
            guess = axis ? std::optional(axis->angleRad) : std::nullopt;
            if (axis && axis->sigmaRad < unknownAxisSigmaRad) {
                one.node.measured = true;
                one.node.position = {std::cos(2 * axis->angleRad), std::sin(2 * axis->angleRad)};
                one.node.covariance = Eigen::Matrix2d::Identity() * (4 * axis->sigmaRad * axis->sigmaRad);
                one.sigmaRad = axis->sigmaRad;
            }
            nodes.push_back(one);
        }
    }
    std::stable_sort(nodes.begin(), nodes.end(),
                     [](const AxisNode &a, const AxisNode &b) { return a.node.timeS < b.node.timeS; });
    return nodes;
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

} // namespace

std::vector<std::vector<BodyAxis>> trackAxis(const std::vector<ViewTrack> &views, const SolidShape &shape)
{
    std::vector<std::vector<BodyAxis>> axes;
    for (const ViewTrack &view : views)
        axes.emplace_back(view.observations.size(), BodyAxis{0, 2 * unknownAxisSigmaRad});
    const std::vector<AxisNode> all = look(views, shape);

    std::vector<std::vector<TrackNode>> segments;
    const auto parts = stretches(all);
    for (const auto &[first, end] : parts) {
        segments.emplace_back();
        for (std::size_t i = first; i < end; ++i)
            segments.back().push_back(all[i].node);
    }
    const std::vector<std::span<const TrackNode>> spans(segments.begin(), segments.end());
    const MotionNoise noise = estimateMotionNoise(spans, false);
    for (std::size_t s = 0; s < segments.size(); ++s) {
        const auto estimates = smoothMotion(segments[s], noise);
        double sigmaRad = 0;
        for (std::size_t i = 0; i < estimates.size(); ++i) {
            const AxisNode &one = all[parts[s].first + i];
            if (one.node.measured)
                sigmaRad = one.sigmaRad;
            axes[one.view][one.observation] = axisOf(estimates[i], sigmaRad);
        }
    }
    return axes;
}

} // namespace odo
