// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace odo {

/// A marker read in an image: its number and corners, clockwise from its top left.
struct ReadMarker
{
    int id = 0;
    std::array<Eigen::Vector2d, 4> corners;

    Eigen::Vector2d centre() const; ///< where the diagonals cross, which perspective keeps
};

/// Where the markers of a ChArUco board lie, in squares: numbered row by row in the squares of one colour.
struct CharucoLayout
{
    int squaresX = 0, squaresY = 0;
    bool startsWithMarker =
        false; ///< the top left square carries marker 0: OpenCV up to 4.5 with an even number of rows

    int markerCount() const;
    /// Column and row of a marker's square.
    std::optional<Eigen::Vector2i> squareOf(int id) const;
};

/// The layout that explains what was read: by the smallest misfit of a homography of the marker centres,
/// which must stay below a fifth of a square. columns and rows count inner corners; 0 finds them out (rows
/// from the highest number read). nullopt where fewer than four markers were read or none fits.
std::optional<CharucoLayout> explainMarkers(const std::vector<ReadMarker> &markers, int columns, int rows);

/// Side of a marker over side of a square, measured.
double measuredMarkerRatio(const std::vector<ReadMarker> &markers, const CharucoLayout &layout);

} // namespace odo
