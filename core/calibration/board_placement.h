// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"

#include <array>
#include <optional>
#include <vector>

namespace odo {

/// Position, size and slope of a board in an image, from its homography alone, without intrinsics.
struct BoardPlacement
{
    /// The outermost inner corners that were seen, in the board's order (first, along x, opposite, along y).
    /// Luma pixels.
    std::array<Eigen::Vector2d, 4> outline{};
    /// Of the middle: 0 to 1 between the edges of the image, as far as a board of this size can go.
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    double size = 0; ///< root of the outline's area over the image's: 0 to 1
    /// The board's slope: its length is the angle between the board and a frontal one over 45°, from the
    /// foreshortening at its middle (cos of the angle); it points to where the board is farther away, x
    /// right, y down.
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();

    static constexpr double fullSlopeDegrees = 45;

    double skew() const { return slope.norm(); }
    double angleDegrees() const;
};

/// nullopt where the corners do not lie as on a plane (fewer than four, collinear, folded).
std::optional<BoardPlacement> placementOf(const BoardView &view, int widthPx, int heightPx);

/// BoardPlacement::slope alone; nullopt as above.
std::optional<Eigen::Vector2d> slopeOf(const BoardView &view);

/// How different two placements are: the sum of the differences of position, size and slope.
double distanceOf(const BoardPlacement &one, const BoardPlacement &other);

/// How much of what a calibration needs the images already cover.
struct BoardCoverage
{
    static constexpr int across = 8, down = 6; ///< fields of the image

    /// 0 to 1 each: across the image, down it, near, tilted. Full at 0.7 of the width and height, when the
    /// board once filled 0.4 of the image (by its side), and when it was tilted by half of 45° to two sides
    /// that differ.
    double x = 0, y = 0, size = 0, skew = 0;
    std::array<int, across * down> corners{}; ///< seen in each field, row by row
    int images = 0;

    double coveredPart() const; ///< of the fields
    /// All four are full, half of the fields have corners, and there are ten images; or there are forty.
    bool isEnough() const;
};

/// The required spans are those that ROS's camera_calibration found to be enough (its source, 2008 to 2024).
BoardCoverage coverageOf(const std::vector<BoardView> &views, const std::vector<BoardPlacement> &placements,
                         int widthPx, int heightPx);

/// What a person should do with the board next.
enum class BoardHint {
    Left,
    Right,
    Up,
    Down,
    Closer,
    Farther,
    TiltLeft,
    TiltRight,
    TiltUp,
    TiltDown,
    HoldStill
};

/// The board pose that would add most to the images so far.
struct WantedPose
{
    BoardPlacement placement; ///< with the outline to draw
};

/// Of a fixed set of poses (all over the image, near and far, tilted to each side) the one that is least like
/// any taken; among equals the plainest first. columns and rows: of the board's inner corners, for the shape
/// of the outline.
WantedPose wantedPose(const std::vector<BoardPlacement> &taken, int columns, int rows, int widthPx,
                      int heightPx);

/// The largest step from the board's pose to the requested one. HoldStill: it is there. TiltLeft: the left
/// side away from the camera; TiltUp: the upper side away from it.
BoardHint hintTowards(const WantedPose &wanted, const BoardPlacement &now);

} // namespace odo
