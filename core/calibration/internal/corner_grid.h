// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

namespace odo {

/// Inner corners of a checkerboard, row by row; right-handed with x right and y down.
struct CornerGrid
{
    int columns = 0, rows = 0;
    std::vector<cv::Point2f> corners;

    const cv::Point2f &at(int column, int row) const
    {
        return corners[static_cast<std::size_t>(row * columns + column)];
    }
    /// Median distance of neighbouring corners.
    float spacing() const;
};

/// The largest checkerboard of an 8-bit image, whatever its size: from a saddle point and two of its
/// neighbours the grid is grown corner by corner, each checked against the four fields around it. The board's
/// outer squares may be cut off. Corners to about half a pixel. Empty (0×0) when there is none of at least
/// 3×3 corners with squares of 9 pixels.
CornerGrid findCornerGrid(const cv::Mat &grey);

/// A point where four fields meet, dark and bright by turns, as at an inner corner of a checkerboard.
struct SaddlePoint
{
    cv::Point2f position;
    std::array<cv::Point2f, 2> edges; ///< unit vectors along the two lines that cross here
};

/// Saddle points of an 8-bit image that has been smoothed a little, strongest first (determinant of the
/// Hessian, then a ring of five pixels radius that must change four times between dark and bright).
std::vector<SaddlePoint> findSaddlePoints(const cv::Mat &smoothed);

/// Grey value between pixels; the border is continued outwards.
float greyAt(const cv::Mat &image, cv::Point2f position);

} // namespace odo
