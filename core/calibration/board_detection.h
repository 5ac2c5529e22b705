// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/frame.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace odo {

enum class BoardPattern { Checkerboard, Charuco };

/// The board to find. Columns and rows count inner corners.
struct BoardSpec
{
    std::optional<BoardPattern> pattern; ///< nullopt: find out
    int columns = 0, rows = 0;           ///< 0: find out
    double squareM = 0.025;
    double markerRatio = 0.5; ///< ChArUco: marker side / square side
    std::string dictionary;   ///< ChArUco: e.g. "DICT_6X6_250"; empty: find out
};

/// With fewer corners a view does not constrain the intrinsics.
inline constexpr std::size_t leastCornersOfView = 6;

/// Corners found in one image, with their board coordinates (metres, z = 0).
struct BoardView
{
    std::string source; ///< file, or file@frame
    int columns = 0, rows = 0;
    std::vector<Eigen::Vector2d> pixels;
    std::vector<Eigen::Vector2d> pointsOnBoard;
    BoardPattern pattern = BoardPattern::Checkerboard;
    /// from 10 to 90 % of an edge's step, the upper quartile; 0 where it is not measured
    double edgeWidthPx = 0;
};

/// Half the widest window in which a corner is refined, pixels.
inline constexpr int widestCornerWindowPx = 11;

/// Why an image has no usable board: Undetermined.
tl::unexpected<Error> refuseBoard(const std::string &source, Message why, Message advice);

/// Why an image of another size than most of them, or than those before it, cannot be used.
Message otherSizeThanMost(int widthPx, int heightPx, int mostWidthPx, int mostHeightPx);

/// Why a view of another board than the wanted one cannot be used.
Message boardOfOtherSize(const BoardView &view, const BoardSpec &wanted);

/// Finds the board in the luma plane. Error Undetermined with the reason: none found, another size found, too
/// blurred, cut off.
Result<BoardView> findBoard(const Frame &frame, const BoardSpec &spec, const std::string &source);

} // namespace odo
