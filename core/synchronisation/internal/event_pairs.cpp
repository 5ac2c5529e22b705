// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/event_pairs.h"

#include "core/synchronisation/internal/clip_synchronisation.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double shortestRateSpanS = 20;
constexpr std::size_t fewestForRate = 3;

ClockLine lineThrough(const std::vector<EventPair> &pairs, bool withRate)
{
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const EventPair &pair : pairs) {
        const Eigen::Vector2d row(1, withRate ? -pair.secondS : 0.0);
        normal += row * row.transpose() / pair.variance;
        right += row * pair.offsetS() / pair.variance;
    }
    if (!withRate)
        normal(1, 1) = 1;
    const Eigen::Matrix2d covariance = normal.inverse();
    const Eigen::Vector2d solved = covariance * right;
    double chiSquare = 0;
    for (const EventPair &pair : pairs) {
        const double residual = pair.offsetS() - solved.x() + (withRate ? solved.y() * pair.secondS : 0.0);
        chiSquare += residual * residual / pair.variance;
    }
    const double freedom = std::max(1.0, double(pairs.size()) - (withRate ? 2 : 1));
    const double scatter = std::sqrt(std::max(1.0, chiSquare / freedom));
    return {solved.x(), withRate ? solved.y() : 0.0, scatter * std::sqrt(covariance(0, 0)),
            withRate ? scatter * std::sqrt(covariance(1, 1)) : 0.0};
}

double spanS(const std::vector<EventPair> &pairs)
{
    const auto [from, to] = std::ranges::minmax_element(pairs, {}, &EventPair::secondS);
    return to->secondS - from->secondS;
}

} // namespace

ClockLine clockLineThrough(const std::vector<EventPair> &pairs)
{
    ClockLine line = lineThrough(pairs, false);
    if (pairs.size() >= fewestForRate && spanS(pairs) > shortestRateSpanS) {
        const ClockLine tilted = lineThrough(pairs, true);
        if (std::abs(tilted.rate) > 3 * tilted.rateSigma && std::abs(tilted.rate) < largestClockRate)
            return tilted;
        line.rateSigma = tilted.rateSigma;
    }
    return line;
}

} // namespace odo
