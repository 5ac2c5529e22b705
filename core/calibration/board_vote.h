// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"

#include <optional>
#include <string>
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
/// camera, of images of this size, each searched for any board or for the likely one first
/// (findBoardForVote). 0 columns without views. Pure; any thread.
BoardKind votedBoard(const std::vector<BoardView> &views, int widthPx, int heightPx);

/// The voted board once so many views show it that further images are searched for it first, which is quicker
/// and finds parts of it. Pure; any thread.
std::optional<BoardKind> likelyBoard(const std::vector<BoardView> &views, int widthPx, int heightPx);

/// The board to find where it is of this kind.
BoardSpec specOf(const BoardSpec &asked, const BoardKind &kind);

/// findBoard for a vote: where `asked` leaves the board's size open, a likely board first, then any; why the
/// likely one was not found where none was. Errors: those of findBoard.
Result<BoardView> findBoardForVote(const Frame &frame, const BoardSpec &asked,
                                   const std::optional<BoardKind> &likely, const std::string &source);

} // namespace odo
