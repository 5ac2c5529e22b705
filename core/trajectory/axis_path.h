// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace odo {

/// Angles of half a turn that a body's axis is searched at.
constexpr std::size_t axisBins = 48;
double angleOfBin(std::size_t bin);

/// How badly each angle explains an outline: squared misfit in σ².
using AxisCosts = std::array<float, axisBins>;

/// One time of a run: what an outline says of the axis, or nothing.
struct AxisEvidence
{
    double timeS = 0;
    std::optional<AxisCosts> costs;
};

/// The angles of the likeliest turning through all times (Viterbi 1967): an outline seen face on fits two
/// angles mirrored about it nearly as well, and only what comes before and after tells which. A body turns at
/// some 4 rad/s (σ); an outline costs at most 25, so that a wrong one is overruled. One bin for each of `times` times,
/// whose evidence is asked for once each, in their order.
std::vector<std::uint8_t> likeliestPath(std::size_t times,
                                        const std::function<AxisEvidence(std::size_t)> &evidenceAt);

} // namespace odo
