// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/axis_track.h"

#include "core/trajectory/axis_path.h"
#include "core/trajectory/kalman_smoother.h"
#include "core/trajectory/view_clock.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

namespace odo {

namespace {

constexpr double leastAxisScore = 0.3;
constexpr double longestGapS = 1.0; // an axis that was not seen for longer may be any
constexpr double commonShare = 0.5; // of an outline's doubt that all frames share

/// Where an observation is among the views'.
struct Place
{
    std::uint32_t view = 0, observation = 0;
};

/// All views' observations in the order of time, with the axes that their outlines show. A run has a hundred thousand
/// of them: what an outline says is asked again where it is wanted, not kept.
class AxisNodes
{
public:
    AxisNodes(const std::vector<ViewTrack> &views, const SolidShape &shape) : m_views(views), m_shape(shape)
    {
        const auto timeAt = [&](Place place) { return toSeconds(timeOf(views[place.view], observationAt(place))); };
        for (std::size_t v = 0; v < views.size(); ++v) {
            for (std::size_t i = 0; i < views[v].observations.size(); ++i)
                m_places.push_back({static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(i)});
        }
        std::stable_sort(m_places.begin(), m_places.end(),
                         [&](Place a, Place b) { return timeAt(a) < timeAt(b); });
        m_nodes.reserve(m_places.size());
        for (const Place place : m_places)
            m_nodes.push_back({timeAt(place)});
        m_sigmaRad.resize(m_places.size());
    }

    std::size_t size() const { return m_places.size(); }
    Place place(std::size_t i) const { return m_places[i]; }
    const TrackNode &node(std::size_t i) const { return m_nodes[i]; }
    std::span<const TrackNode> nodes() const { return m_nodes; }
    /// Of the last measured axis up to a node that is not the first of its stretch.
    double outlineSigmaRad(std::size_t i) const
    {
        while (!m_nodes[i].measured)
            --i;
        return m_sigmaRad[i];
    }

    /// nullopt: the outline tells nothing.
    std::optional<OutlineMisfit> misfit(std::size_t i) const
    {
        return isClear(i) ? OutlineMisfit::create(*m_views[m_places[i].view].floorView, m_shape, outlineMoments(observationAt(m_places[i]))) : std::nullopt;
    }

    /// The direction near one that is about known; nullopt as before.
    std::optional<BodyAxis> bySupport(std::size_t i, const OutlineDifference &difference, double aboutRad) const
    {
        constexpr double followRad = 0.3; // from one observation to the next
        const Observation &observation = observationAt(m_places[i]);
        const auto &view = m_views[m_places[i].view].floorView;
        const auto start = isClear(i) ? view->floorFromPixel(observation.ellipse.centrePx, middleHeightM(m_shape)) : std::nullopt;
        const auto placed = start ? placeBySupport(*view, m_shape, observation, difference, {*start, {aboutRad, followRad}}) : std::nullopt;
        return placed && placed->axis.sigmaRad < followRad / 2 ? std::optional(placed->axis) : std::nullopt;
    }

    void measure(std::size_t i, const BodyAxis &axis)
    {
        m_nodes[i].measured = true;
        m_nodes[i].position = {std::cos(2 * axis.angleRad), std::sin(2 * axis.angleRad)};
        m_nodes[i].covariance = Eigen::Matrix2d::Identity() * (4 * axis.sigmaRad * axis.sigmaRad);
        m_sigmaRad[i] = axis.sigmaRad;
    }

private:
    bool isClear(std::size_t i) const
    {
        const Observation &observation = observationAt(m_places[i]);
        return m_views[m_places[i].view].floorView && observation.found && !observation.duplicateFrame && !observation.touchesBorder &&
               observation.score >= leastAxisScore;
    }
    const Observation &observationAt(Place place) const
    {
        return m_views[place.view].observations[place.observation];
    }

    const std::vector<ViewTrack> &m_views;
    const SolidShape &m_shape;
    std::vector<Place> m_places;
    std::vector<TrackNode> m_nodes;
    std::vector<double> m_sigmaRad; ///< of the outline's axis, where it was measured
};

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

/// Gives each node the axis near the likeliest turning.
void measureAxes(AxisNodes &nodes)
{
    std::vector<bool> tells(nodes.size());
    const auto path = likeliestPath(nodes.size(), [&](std::size_t i) {
        const auto misfit = nodes.misfit(i);
        AxisEvidence evidence{nodes.node(i).timeS, misfit ? costsOf(*misfit) : std::nullopt};
        tells[i] = evidence.costs.has_value();
        return evidence;
    });
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!tells[i])
            continue;
        const auto axis = axisAbout(*nodes.misfit(i), angleOfBin(path[i]));
        if (axis && axis->sigmaRad <= unknownAxisSigmaRad)
            nodes.measure(i, *axis);
    }
}

/// Stretches [first, end) from a measured node to a measured one without a long gap.
std::vector<std::pair<std::size_t, std::size_t>> stretches(std::span<const TrackNode> nodes)
{
    std::vector<std::pair<std::size_t, std::size_t>> found;
    double lastS = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].measured)
            continue;
        if (found.empty() || nodes[i].timeS - lastS > longestGapS)
            found.emplace_back(i, i + 1);
        found.back().second = i + 1;
        lastS = nodes[i].timeS;
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
std::vector<BodyAxis> smooth(const AxisNodes &nodes)
{
    std::vector<BodyAxis> axes(nodes.size(), BodyAxis{0, 2 * unknownAxisSigmaRad});
    const auto parts = stretches(nodes.nodes());
    std::vector<std::span<const TrackNode>> segments;
    for (const auto &[first, end] : parts)
        segments.push_back(nodes.nodes().subspan(first, end - first));
    const MotionNoise noise = estimateMotionNoise(segments, false);
    for (std::size_t s = 0; s < segments.size(); ++s) {
        const std::size_t first = parts[s].first;
        smoothMotion(segments[s], noise, [&](std::size_t i, const MotionEstimate &estimate) {
            axes[first + i] = axisOf(estimate, nodes.outlineSigmaRad(first + i));
        });
    }
    return axes;
}

/// Once the turning is known, the outlines can be asked more finely: each for the fit next to it.
void refineAxes(AxisNodes &nodes, const std::vector<BodyAxis> &smoothed)
{
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes.node(i).measured || smoothed[i].sigmaRad > unknownAxisSigmaRad)
            continue;
        const auto axis = axisNear(*nodes.misfit(i), smoothed[i].angleRad);
        if (axis && axis->sigmaRad < unknownAxisSigmaRad &&
            std::abs(axis->angleRad - smoothed[i].angleRad) < 3 * smoothed[i].sigmaRad)
            nodes.measure(i, *axis);
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
    AxisNodes all(views, shape);
    measureAxes(all);
    refineAxes(all, smooth(all));
    const std::vector<BodyAxis> smoothed = smooth(all);
    for (std::size_t i = 0; i < all.size(); ++i)
        axes[all.place(i).view][all.place(i).observation] = smoothed[i];
    return axes;
}

std::vector<std::vector<BodyAxis>> trackDirection(const std::vector<ViewTrack> &views, const SolidShape &shape, const OutlineDifference &difference,
                                                  const std::vector<BodyPose> &poses)
{
    AxisNodes all(views, shape);
    std::vector<double> headings(all.size());
    double heading = 0;
    const auto follow = [&](std::size_t i) {
        if (const auto axis = all.bySupport(i, difference, heading)) {
            all.measure(i, *axis);
            heading = axis->angleRad;
        }
        headings[i] = heading;
    };
    const auto firstOf = [&](const BodyPose &pose) {
        const auto nodes = all.nodes();
        return std::size_t(std::ranges::lower_bound(nodes, toSeconds(pose.time), {}, &TrackNode::timeS) - nodes.begin());
    };
    for (std::size_t p = 0; p < poses.size(); ++p) {
        heading = poses[p].headingRad;
        const std::size_t end = p + 1 < poses.size() ? firstOf(poses[p + 1]) : all.size();
        for (std::size_t i = firstOf(poses[p]); i < end; ++i)
            follow(i);
    }
    heading = poses.front().headingRad;
    for (std::size_t i = firstOf(poses.front()); i-- > 0;)
        follow(i);
    std::vector<std::vector<BodyAxis>> axes;
    for (const ViewTrack &view : views)
        axes.emplace_back(view.observations.size());
    const std::vector<BodyAxis> smoothed = smooth(all);
    for (std::size_t i = 0; i < all.size(); ++i)
        axes[all.place(i).view][all.place(i).observation] = {headings[i] + std::remainder(smoothed[i].angleRad - headings[i], std::numbers::pi), smoothed[i].sigmaRad};
    return axes;
}

} // namespace odo
