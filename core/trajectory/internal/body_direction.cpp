// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/body_direction.h"

#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/motion_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

namespace odo {

std::vector<std::vector<BodyAxis>> directionsOfMotion(const std::vector<ViewTrack> &views,
                                                      const std::vector<std::vector<Sighting>> &sightings,
                                                      const std::vector<std::vector<BodyAxis>> &axes)
{
    constexpr double windowS = 0.2, leastDistanceM = 0.03, guessSigmaRad = 0.15, nearRad = 0.4;
    std::vector<std::vector<BodyAxis>> directions;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const std::vector<Sighting> &seen = sightings[v];
        directions.emplace_back(views[v].observations.size(), BodyAxis{0, 2 * unknownAxisSigmaRad});
        for (std::size_t i = 0, first = 0, last = 0; i < seen.size(); ++i) {
            const double timeS = toSeconds(seen[i].time);
            while (toSeconds(seen[first].time) < timeS - windowS)
                ++first;
            while (last + 1 < seen.size() && toSeconds(seen[last + 1].time) <= timeS + windowS)
                ++last;
            // The slope of the positions over time, by least squares.
            double n = 0, t = 0, tt = 0;
            Eigen::Vector2d p = Eigen::Vector2d::Zero(), tp = Eigen::Vector2d::Zero();
            for (std::size_t k = first; k <= last; ++k) {
                if (!seen[k].seen)
                    continue;
                const double dt = toSeconds(seen[k].time) - timeS;
                n += 1;
                t += dt;
                tt += dt * dt;
                p += seen[k].position.pointInWorld;
                tp += dt * seen[k].position.pointInWorld;
            }
            const double spread = n * tt - t * t;
            if (n < 3 || spread <= 0)
                continue;
            const Eigen::Vector2d velocity = (n * tp - t * p) / spread;
            if (velocity.norm() * windowS < leastDistanceM)
                continue;
            const double moving = std::atan2(velocity.y(), velocity.x()),
                         away = std::remainder(axes[v][i].angleRad - moving, std::numbers::pi);
            const bool agrees = axes[v][i].sigmaRad <= unknownAxisSigmaRad && std::abs(away) < nearRad;
            directions[v][i] =
                agrees ? BodyAxis{moving + away, axes[v][i].sigmaRad} : BodyAxis{moving, guessSigmaRad};
        }
    }
    return directions;
}

std::optional<BodyMotion> motionAt(const std::vector<std::vector<Sighting>> &sightings, Nanoseconds time)
{
    constexpr double windowS = 0.25, slowestMps = 0.15;
    constexpr int fewest = 6;
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero(), acceleration = Eigen::Vector2d::Zero();
    double views = 0;
    for (const std::vector<Sighting> &seen : sightings) {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Matrix<double, 3, 2> right = Eigen::Matrix<double, 3, 2>::Zero();
        int count = 0;
        const auto from = std::ranges::lower_bound(seen, toSeconds(time) - windowS, {},
                                                   [](const Sighting &one) { return toSeconds(one.time); });
        for (auto one = from; one != seen.end() && toSeconds(one->time - time) <= windowS; ++one) {
            if (!one->seen)
                continue;
            const double t = toSeconds(one->time - time);
            const Eigen::Vector3d row(1, t, t * t / 2);
            normal += row * row.transpose();
            right += row * one->position.pointInWorld.transpose();
            ++count;
        }
        if (count < fewest)
            continue;
        const Eigen::Matrix<double, 3, 2> solution = normal.ldlt().solve(right);
        velocity += solution.row(1).transpose();
        acceleration += solution.row(2).transpose();
        views += 1;
    }
    velocity /= std::max(1.0, views);
    acceleration /= std::max(1.0, views);
    const double speed = velocity.norm();
    if (views == 0 || speed < slowestMps)
        return std::nullopt;
    return BodyMotion{std::atan2(velocity.y(), velocity.x()),
                      (velocity.x() * acceleration.y() - velocity.y() * acceleration.x()) /
                          (speed * speed * speed)};
}

namespace {

constexpr double leastAxisScore = 0.3;
constexpr double longestGapS = 1.0; // an axis that was not seen for longer may be any
constexpr double commonShare = 0.5; // of an outline's uncertainty that all frames share

/// Where an observation is among the views'.
struct RobotPosition
{
    std::uint32_t view = 0, observation = 0;
};

/// All views' observations in the order of time, with the axes that their outlines show. A run has a hundred
/// thousand of them: what an outline shows is recomputed where it is needed, not kept.
class AxisNodes
{
public:
    AxisNodes(const std::vector<ViewTrack> &views, const SolidShape &shape) : m_views(views), m_shape(shape)
    {
        const auto timeAt = [&](RobotPosition position) {
            return toSeconds(timeOf(views[position.view], observationAt(position)));
        };
        for (std::size_t v = 0; v < views.size(); ++v) {
            for (std::size_t i = 0; i < views[v].observations.size(); ++i)
                m_positions.push_back({static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(i)});
        }
        std::stable_sort(m_positions.begin(), m_positions.end(),
                         [&](RobotPosition a, RobotPosition b) { return timeAt(a) < timeAt(b); });
        m_nodes.reserve(m_positions.size());
        for (const RobotPosition position : m_positions)
            m_nodes.push_back({timeAt(position)});
        m_sigmaRad.resize(m_positions.size());
    }

    std::size_t size() const { return m_positions.size(); }
    RobotPosition position(std::size_t i) const { return m_positions[i]; }
    const TrackNode &node(std::size_t i) const { return m_nodes[i]; }
    std::span<const TrackNode> nodes() const { return m_nodes; }
    /// Of the last measured axis up to a node that is not the first of its stretch.
    double outlineSigmaRad(std::size_t i) const
    {
        while (!m_nodes[i].measured)
            --i;
        return m_sigmaRad[i];
    }

    /// nullopt: the outline shows no axis.
    std::optional<OutlineMisfit> misfit(std::size_t i) const
    {
        return isClear(i) ? OutlineMisfit::create(*m_views[m_positions[i].view].floorView, m_shape,
                                                  outlineMoments(observationAt(m_positions[i])))
                          : std::nullopt;
    }

    /// The direction near one that is about known; nullopt as before.
    std::optional<BodyAxis> bySupport(std::size_t i, const OutlineDifference &difference,
                                      double aboutRad) const
    {
        constexpr double followRad = 0.3; // from one observation to the next
        const Observation &observation = observationAt(m_positions[i]);
        const auto &view = m_views[m_positions[i].view].floorView;
        const auto start = isClear(i)
                               ? view->floorFromPixel(observation.ellipse.centrePx, middleHeightM(m_shape))
                               : std::nullopt;
        const auto placed = start ? positionBySupport(*view, m_shape, observation, difference,
                                                      {*start, {aboutRad, followRad}})
                                  : std::nullopt;
        return placed && placed->axis.sigmaRad < followRad / 2 ? std::optional(placed->axis) : std::nullopt;
    }

    /// All that were measured, in order of time.
    std::vector<MeasuredAxis> measured() const
    {
        std::vector<MeasuredAxis> axes;
        for (std::size_t i = 0; i < m_nodes.size(); ++i) {
            const Eigen::Vector2d &doubled = m_nodes[i].position;
            if (m_nodes[i].measured)
                axes.push_back({m_positions[i].view,
                                m_positions[i].observation,
                                {std::atan2(doubled.y(), doubled.x()) / 2, m_sigmaRad[i]}});
        }
        return axes;
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
        const Observation &observation = observationAt(m_positions[i]);
        return m_views[m_positions[i].view].floorView && observation.found && !observation.duplicateFrame &&
               !observation.touchesBorder && !observation.isByHand && observation.score >= leastAxisScore;
    }
    const Observation &observationAt(RobotPosition position) const
    {
        return m_views[position.view].observations[position.observation];
    }

    const std::vector<ViewTrack> &m_views;
    const SolidShape &m_shape;
    std::vector<RobotPosition> m_positions;
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

std::vector<std::vector<BodyAxis>> trackAxis(const std::vector<ViewTrack> &views, const SolidShape &shape,
                                             std::vector<MeasuredAxis> *measured)
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
    if (measured)
        *measured = all.measured();
    for (std::size_t i = 0; i < all.size(); ++i)
        axes[all.position(i).view][all.position(i).observation] = smoothed[i];
    return axes;
}

std::vector<std::vector<BodyAxis>> trackDirection(const std::vector<ViewTrack> &views,
                                                  const SolidShape &shape,
                                                  const OutlineDifference &difference,
                                                  const std::vector<BodyPose> &poses,
                                                  std::vector<MeasuredAxis> *measured)
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
        return std::size_t(std::ranges::lower_bound(nodes, toSeconds(pose.time), {}, &TrackNode::timeS) -
                           nodes.begin());
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
    if (measured)
        *measured = all.measured();
    for (std::size_t i = 0; i < all.size(); ++i)
        axes[all.position(i).view][all.position(i).observation] = {
            headings[i] + std::remainder(smoothed[i].angleRad - headings[i], std::numbers::pi),
            smoothed[i].sigmaRad};
    return axes;
}

namespace {

constexpr double turnSigmaRadPerS = 4;
constexpr double leastStepSigmaRad = 0.02;
constexpr float mostCost = 25;
constexpr double binRad = std::numbers::pi / axisBins;

/// Cost of a turn by so many bins within a time.
std::array<float, axisBins> turnCosts(double dt)
{
    std::array<float, axisBins> costs{};
    const double sigma = turnSigmaRadPerS * dt + leastStepSigmaRad;
    for (std::size_t turn = 0; turn < axisBins; ++turn) {
        const auto bins = static_cast<double>(std::min(turn, axisBins - turn));
        costs[turn] = static_cast<float>(bins * binRad / sigma * (bins * binRad / sigma));
    }
    return costs;
}

using Origins = std::array<std::uint8_t, axisBins>;

/// The cheapest way into each bin; fills where it comes from.
AxisCosts step(const AxisCosts &before, double dt, Origins &origins)
{
    const auto turn = turnCosts(dt);
    AxisCosts after;
    for (std::size_t to = 0; to < axisBins; ++to) {
        after[to] = before[to];
        origins[to] = static_cast<std::uint8_t>(to);
        for (std::size_t by = 1; by < axisBins; ++by) {
            const std::size_t from = (to + by) % axisBins;
            if (const float cost = before[from] + turn[by]; cost < after[to]) {
                after[to] = cost;
                origins[to] = static_cast<std::uint8_t>(from);
            }
        }
    }
    return after;
}

} // namespace

double angleOfBin(std::size_t bin)
{
    return static_cast<double>(bin) * binRad;
}

std::vector<std::uint8_t> likeliestPath(std::size_t times,
                                        const std::function<AxisEvidence(std::size_t)> &evidenceAt)
{
    std::vector<Origins> origins(times);
    AxisCosts total{};
    double beforeS = 0;
    for (std::size_t i = 0; i < times; ++i) {
        const AxisEvidence evidence = evidenceAt(i);
        if (i > 0)
            total = step(total, std::max(0.0, evidence.timeS - beforeS), origins[i]);
        beforeS = evidence.timeS;
        if (!evidence.costs)
            continue;
        for (std::size_t bin = 0; bin < axisBins; ++bin)
            total[bin] += std::min((*evidence.costs)[bin], mostCost);
        // Kept small, so that floats stay exact over hours.
        const float least = *std::min_element(total.begin(), total.end());
        for (float &cost : total)
            cost -= least;
    }
    std::vector<std::uint8_t> path(times);
    auto bin = static_cast<std::uint8_t>(std::min_element(total.begin(), total.end()) - total.begin());
    for (std::size_t i = times; i-- > 0;) {
        path[i] = bin;
        bin = origins[i][bin];
    }
    return path;
}

} // namespace odo
