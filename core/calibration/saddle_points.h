// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

namespace odo {

/// A place where four fields meet, dark and bright by turns, as at an inner corner of a checkerboard.
struct SaddlePoint
{
    cv::Point2f position;
    std::array<cv::Point2f, 2> edges; ///< unit vectors along the two lines that cross here
};

/// Saddle points of an 8-bit picture that has been smoothed a little, strongest first (determinant of the
/// Hessian, then a ring of five pixels radius that must change four times between dark and bright).
std::vector<SaddlePoint> findSaddlePoints(const cv::Mat &smoothed);

/// Grey value between pixels; the border is continued outwards.
float greyAt(const cv::Mat &picture, cv::Point2f position);

} // namespace odo
