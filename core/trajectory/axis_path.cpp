// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/axis_path.h"

#include <algorithm>
#include <numbers>

namespace odo {

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
