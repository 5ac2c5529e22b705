// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/body_direction.h"

#include "core/trajectory/view_clock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double longestUnknownS = 1; // after which it may have turned to any side

struct DirectedNode
{
    double timeS = 0;
    std::size_t view = 0, observation = 0;
};

/// How far the body moved forward since the sighting before in the same view.
double forwardM(const std::vector<Sighting> &sightings, std::size_t at, double angleRad)
{
    if (at == 0 || !sightings[at].seen || !sightings[at - 1].seen)
        return 0;
    const Eigen::Vector2d moved = sightings[at].place.pointInWorld - sightings[at - 1].place.pointInWorld;
    return moved.dot(Eigen::Vector2d(std::cos(angleRad), std::sin(angleRad)));
}

} // namespace

std::vector<std::vector<BodyAxis>> directedAxes(const std::vector<ViewTrack> &views, const std::vector<std::vector<Sighting>> &sightings,
                                                std::vector<std::vector<BodyAxis>> axes)
{
    std::vector<DirectedNode> nodes;
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t i = 0; i < axes[v].size() && !sightings[v].empty(); ++i) {
            if (axes[v][i].sigmaRad <= unknownAxisSigmaRad)
                nodes.push_back({toSeconds(timeOf(views[v], views[v].observations[i])), v, i});
        }
    }
    std::ranges::stable_sort(nodes, {}, &DirectedNode::timeS);
    for (std::size_t first = 0; first < nodes.size();) {
        double forward = 0;
        std::size_t end = first;
        for (; end < nodes.size() && (end == first || nodes[end].timeS - nodes[end - 1].timeS < longestUnknownS); ++end) {
            const DirectedNode &node = nodes[end];
            double &angle = axes[node.view][node.observation].angleRad;
            if (end > first) {
                const double before = axes[nodes[end - 1].view][nodes[end - 1].observation].angleRad;
                angle = before + std::remainder(angle - before, std::numbers::pi);
            }
            forward += forwardM(sightings[node.view], node.observation, angle);
        }
        for (std::size_t i = first; i < end && forward < 0; ++i)
            axes[nodes[i].view][nodes[i].observation].angleRad += std::numbers::pi;
        first = end;
    }
    return axes;
}

std::vector<std::vector<BodyAxis>> directionsOfMotion(const std::vector<ViewTrack> &views, const std::vector<std::vector<Sighting>> &sightings,
                                                      const std::vector<std::vector<BodyAxis>> &axes)
{
    constexpr double windowS = 0.2, leastWayM = 0.03, guessSigmaRad = 0.15, nearRad = 0.4;
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
            // The slope of the places over time, by least squares.
            double n = 0, t = 0, tt = 0;
            Eigen::Vector2d p = Eigen::Vector2d::Zero(), tp = Eigen::Vector2d::Zero();
            for (std::size_t k = first; k <= last; ++k) {
                if (!seen[k].seen)
                    continue;
                const double dt = toSeconds(seen[k].time) - timeS;
                n += 1;
                t += dt;
                tt += dt * dt;
                p += seen[k].place.pointInWorld;
                tp += dt * seen[k].place.pointInWorld;
            }
            const double spread = n * tt - t * t;
            if (n < 3 || spread <= 0)
                continue;
            const Eigen::Vector2d velocity = (n * tp - t * p) / spread;
            if (velocity.norm() * windowS < leastWayM)
                continue;
            const double moving = std::atan2(velocity.y(), velocity.x()), away = std::remainder(axes[v][i].angleRad - moving, std::numbers::pi);
            const bool agrees = axes[v][i].sigmaRad <= unknownAxisSigmaRad && std::abs(away) < nearRad;
            directions[v][i] = agrees ? BodyAxis{moving + away, axes[v][i].sigmaRad} : BodyAxis{moving, guessSigmaRad};
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
        const auto from = std::ranges::lower_bound(seen, toSeconds(time) - windowS, {}, [](const Sighting &one) { return toSeconds(one.time); });
        for (auto one = from; one != seen.end() && toSeconds(one->time - time) <= windowS; ++one) {
            if (!one->seen)
                continue;
            const double t = toSeconds(one->time - time);
            const Eigen::Vector3d row(1, t, t * t / 2);
            normal += row * row.transpose();
            right += row * one->place.pointInWorld.transpose();
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
    return BodyMotion{std::atan2(velocity.y(), velocity.x()), (velocity.x() * acceleration.y() - velocity.y() * acceleration.x()) / (speed * speed * speed)};
}

} // namespace odo
