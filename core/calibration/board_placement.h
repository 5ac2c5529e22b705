// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"

#include <array>
#include <optional>

namespace odo {

/// How a board stands in a picture, in figures that need no lens: from its homography alone.
struct BoardPlacement
{
    /// The outermost inner corners that were seen, in the board's order (first, along x, opposite, along y). Luma pixels.
    std::array<Eigen::Vector2d, 4> outline{};
    /// Of the middle: 0 to 1 between the edges of the picture, as far as a board of this size can go.
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double size = 0; ///< root of the outline's area over the picture's: 0 to 1
    /// The board's slope: its length is the angle between the board and a frontal one over 45°, from the foreshortening
    /// at its middle (cos of the angle); it points to where the board is farther away, x right, y down.
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();

    double skew() const { return slope.norm(); }
    double angleDegrees() const;
};

/// nullopt where the corners do not lie as on a plane (fewer than four, collinear, folded).
std::optional<BoardPlacement> placementOf(const BoardView &view, int widthPx, int heightPx);

/// How different two placements are: the sum of the differences of place, size and slope.
double distanceOf(const BoardPlacement &one, const BoardPlacement &other);

} // namespace odo
