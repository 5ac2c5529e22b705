// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace odo {

/// The luma plane as OpenCV wants it, without a copy. Read only, and only while the frame lives.
inline cv::Mat lumaMatrix(const Frame &frame)
{
    // cv::Mat knows no pixels that are only read.
    auto *pixels =
        const_cast<std::uint8_t *>(frame.y.data); // NOLINT(cppcoreguidelines-pro-type-const-cast): see above
    return cv::Mat(frame.y.height, frame.y.width, CV_8UC1, pixels, static_cast<std::size_t>(frame.y.stride));
}

/// Boards and markers are detected in an image of at most so many pixels, and then measured in the image
/// itself: detection takes many times the memory of the image.
inline constexpr double mostSearchedPixels = 12e6;

/// How much smaller than the image that one is; 1 where the image is small enough itself.
double searchScale(const cv::Mat &luma);

/// The image at a scale of at most 1, by averages; itself, not a copy, where the scale is 1.
cv::Mat reduced(const cv::Mat &luma, double scale);

/// From pixels of reduced(luma, scale) to those of the image. Pixel (0, 0) is the centre of a pixel: scaling
/// keeps the corner of the first one, half a pixel before it.
inline double unscaled(double pixel, double scale)
{
    return (pixel + 0.5) / scale - 0.5;
}
inline cv::Point2f unscaled(cv::Point2f position, double scale)
{
    const auto back = static_cast<float>(1 / scale);
    return {(position.x + 0.5F) * back - 0.5F, (position.y + 0.5F) * back - 0.5F};
}

} // namespace odo
