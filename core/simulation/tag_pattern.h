// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace odo {

/// A square pattern of black and white cells, from its top-left corner, row by row.
struct TagPattern
{
    int side = 0;
    std::vector<bool> black;

    bool isBlack(int column, int row) const
    {
        return black[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                     static_cast<std::size_t>(column)];
    }
};

/// AprilTag 36h11: 10 × 10 cells with the white rim; the black square is the inner 8 × 8.
TagPattern aprilTagPattern(int id);
/// ArUco of OpenCV's dictionary 6X6_250: 8 × 8 cells, the black rim outermost.
TagPattern arucoPattern(int id);

} // namespace odo
