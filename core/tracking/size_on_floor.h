// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/floor_view.h"
#include "core/video/pixel_rect.h"

#include <optional>

namespace odo {

/// How large something is at least that stands on the floor and fills a box of the picture, in metres.
struct SizeOnFloor
{
    double widthM = 0;
    /// The lesser of its depth, were it flat on the floor, and of its height, were it as thin as a wall: a body of height H and depth L that is seen e below the
    /// horizontal has L + H/tan e and H + L·tan e.
    double reachM = 0;
};

/// nullopt: its lower edge lies beyond the horizon. Pure.
std::optional<SizeOnFloor> sizeOnFloor(const FloorView &view, const PixelRect &box);

/// Whether it is too large for a robot: people are, while they stand or walk.
bool isTooLargeForRobot(const FloorView &view, const PixelRect &box);

} // namespace odo
