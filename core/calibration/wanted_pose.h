// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_placement.h"

#include <vector>

namespace odo {

/// What a person should do with the board next.
enum class BoardHint { Left, Right, Up, Down, Closer, Farther, TiltLeft, TiltRight, TiltUp, TiltDown, HoldStill };

/// A pose of the board that would add most to the pictures there are.
struct WantedPose
{
    BoardPlacement placement; ///< with the outline to draw
};

/// Of a fixed set of poses (all over the picture, near and far, tilted to each side) the one that is least like any
/// taken; among equals the plainest first. columns and rows: of the board's inner corners, for the shape of the outline.
WantedPose wantedPose(const std::vector<BoardPlacement> &taken, int columns, int rows, int widthPx, int heightPx);

/// The largest step from where the board is to where it is wanted. HoldStill: it is there.
/// TiltLeft: the left side away from the camera; TiltUp: the upper side away from it.
BoardHint hintTowards(const WantedPose &wanted, const BoardPlacement &now);

} // namespace odo
