// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/video/frame.h"

#include <optional>
#include <string_view>
#include <vector>

namespace odo {

/// An inner corner of a ChArUco board that is part of the floor.
struct BoardCorner
{
    int columns = 0, rows = 0; ///< inner corners of the board
    int number = 0;            ///< row by row from the top left, as OpenCV counts them, the first one 0
};

/// "charuco 9x6:12" is corner 12 of a board of 9 × 6 inner corners. nullopt: the label is none, or the board
/// has no such corner.
std::optional<BoardCorner> boardCorner(std::string_view label);

/// The markers of a layout that are corners of a ChArUco board, of any dictionary, in the layout's order;
/// empty where its labels name none. Error: the first board that is named is not found (findBoard).
/// Thread-safe.
Result<std::vector<MarkerPixel>> findBoardCorners(const Frame &frame, const MarkerLayout &layout);

} // namespace odo
