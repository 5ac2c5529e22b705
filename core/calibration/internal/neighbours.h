// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace odo {

/// The indices of the nearest positions, nearest first, without the one itself.
std::vector<int> nearestTo(std::size_t of, std::size_t count, std::size_t most,
                           const std::function<double(std::size_t)> &away);

/// The image of a position by the projective map that fits its neighbours' positions and pixels best, near
/// ones more; the perspective is held near none where they do not determine it. Three pairs or more. nullopt
/// where they determine nothing.
std::optional<Eigen::Vector2d>
predictedByNeighbours(const Eigen::Vector2d &position,
                      const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> &pairs);

} // namespace odo
