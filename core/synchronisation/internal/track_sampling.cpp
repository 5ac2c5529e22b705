// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/track_sampling.h"

#include "core/base/percentile.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double halfWindowS = 0.2;      // of the smoothing: robots do not turn sharply within it
constexpr double longestBridgeS = 0.15;  // positions further apart are not joined
constexpr double finestStepS = 1.0 / 60; // robots move evenly within it

} // namespace

double medianStepS(const std::vector<TimedPosition> &track)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < track.size(); ++i)
        steps.push_back(track[i].timeS - track[i - 1].timeS);
    return steps.empty() ? 0 : upperMedian(std::move(steps));
}

std::vector<TimedPosition> thinned(const std::vector<TimedPosition> &track)
{
    const double stepS = medianStepS(track);
    const auto inAGroup = stepS > 0 ? static_cast<std::size_t>(1.01 * finestStepS / stepS) : 1;
    if (inAGroup < 2)
        return track;
    std::vector<TimedPosition> means;
    for (std::size_t begin = 0, end = 0; begin < track.size(); begin = end) {
        TimedPosition sum{0, Eigen::Vector2d::Zero()};
        do {
            sum.timeS += track[end].timeS;
            sum.pointInWorld += track[end].pointInWorld;
            ++end;
        } while (end < track.size() && end - begin < inAGroup &&
                 track[end].timeS - track[end - 1].timeS < finestStepS);
        const auto count = static_cast<double>(end - begin);
        means.push_back({sum.timeS / count, sum.pointInWorld / count});
    }
    return means;
}

double whiteNoiseM(const std::vector<TimedPosition> &track)
{
    std::vector<double> bends;
    for (std::size_t i = 1; i + 1 < track.size(); ++i)
        bends.push_back(
            (track[i - 1].pointInWorld - 2 * track[i].pointInWorld + track[i + 1].pointInWorld).norm());
    return bends.empty() ? 0 : upperMedian(std::move(bends)) / 1.1774 / std::sqrt(6.0);
}

std::optional<PositionAndVelocity> trackAt(const std::vector<TimedPosition> &track, double timeS)
{
    const auto isBefore = [](const TimedPosition &p, double t) { return p.timeS < t; };
    const auto begin = std::lower_bound(track.begin(), track.end(), timeS - halfWindowS, isBefore);
    const auto end = std::lower_bound(begin, track.end(), timeS + halfWindowS, isBefore);
    if (begin == end || begin->timeS > timeS - halfWindowS / 2 || (end - 1)->timeS < timeS + halfWindowS / 2)
        return std::nullopt;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> right = Eigen::Matrix<double, 3, 2>::Zero();
    for (auto p = begin; p != end; ++p) {
        if (p != begin && p->timeS - (p - 1)->timeS > longestBridgeS)
            return std::nullopt;
        const double u = (p->timeS - timeS) / halfWindowS;
        const double weight = std::pow(1 - std::abs(u * u * u), 3);
        const Eigen::Vector3d powers(1, u, u * u);
        normal += weight * powers * powers.transpose();
        right += weight * powers * p->pointInWorld.transpose();
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
    if (solver.info() != Eigen::Success || solver.vectorD().minCoeff() < 1e-6 * solver.vectorD().maxCoeff())
        return std::nullopt;
    const Eigen::Matrix<double, 3, 2> parabola = solver.solve(right);
    double squares = 0;
    for (auto p = begin; p != end; ++p) {
        const double u = (p->timeS - timeS) / halfWindowS;
        squares += (p->pointInWorld - parabola.transpose() * Eigen::Vector3d(1, u, u * u)).squaredNorm();
    }
    const double variance = squares / std::max(1.0, double(end - begin) - 3);
    const double gain = solver.solve(Eigen::Vector3d(0, 1, 0)).y() / (halfWindowS * halfWindowS);
    return PositionAndVelocity{parabola.row(0).transpose(), parabola.row(1).transpose() / halfWindowS,
                               variance * gain};
}

std::vector<TimedPosition> restamped(std::vector<TimedPosition> track, const ClockRepair &repair)
{
    for (TimedPosition &position : track)
        position.timeS = repair.timeS(position.timeS);
    return track;
}

} // namespace odo
