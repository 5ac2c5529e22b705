// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"

#include <vector>

namespace odo {

/// What a board is, as far as it can be found out.
struct BoardKind
{
    BoardPattern pattern = BoardPattern::Checkerboard;
    int columns = 0, rows = 0; ///< inner corners

    bool operator==(const BoardKind &) const = default;
};

inline BoardKind kindOf(const BoardView &view)
{
    return {view.pattern, view.columns, view.rows};
}

/// The board that most views show; among equals the larger one, then the first. But a board that the border
/// of the image cuts off shows fewer columns or rows: a larger one that two views or more show wins over a
/// smaller one that fits into it, where half of the views of the smaller one reach the border. Views of one
/// camera, of images of this size, none of which was searched for a given board. 0 columns without views.
/// Pure; any thread.
BoardKind votedBoard(const std::vector<BoardView> &views, int widthPx, int heightPx);

} // namespace odo
