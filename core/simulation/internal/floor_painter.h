// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/internal/polygon_layer.h"
#include "core/simulation/scene.h"

namespace odo {

/// Paints what stands still: the room, the floor with its tiles and grain, patches and markers. Takes some
/// 0.2 s.
RgbImage paintFloor(const SimulatedFloor &floor, const FloorView &view);

/// The corners of a rectangle on the floor, in order.
std::vector<Eigen::Vector3d> floorRectangle(const Eigen::Vector2d &lower, const Eigen::Vector2d &upper);

} // namespace odo
