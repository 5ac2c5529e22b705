// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_placement.h"

#include <array>
#include <vector>

namespace odo {

/// How much of what a calibration needs its pictures already have.
struct BoardCoverage
{
    static constexpr int across = 8, down = 6; ///< fields of the picture

    /// 0 to 1 each: across the picture, down it, near, tilted. Full at 0.7 of the width and height, when the board once
    /// filled 0.4 of the picture (by its side), and when it was tilted by half of 45° to two sides that differ.
    double x = 0, y = 0, size = 0, skew = 0;
    std::array<int, across * down> corners{}; ///< seen in each field, row by row
    int pictures = 0;

    double coveredPart() const; ///< of the fields
    /// All four are full, half of the fields have corners, and there are ten pictures; or there are forty.
    bool isEnough() const;
};

/// The spans that are wanted are those that ROS's camera_calibration found to be enough (its source, 2008 to 2024).
BoardCoverage coverageOf(const std::vector<BoardView> &views, const std::vector<BoardPlacement> &placements,
                         int widthPx, int heightPx);

} // namespace odo
