// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <opencv2/core/mat.hpp>

namespace odo {

/// The luma plane as OpenCV wants it, without a copy. Read only, and only while the frame lives.
inline cv::Mat lumaMatrix(const Frame &frame)
{
    // cv::Mat knows no pixels that are only read.
    auto *pixels = const_cast<std::uint8_t *>(frame.y.data); // NOLINT(cppcoreguidelines-pro-type-const-cast): see above
    return cv::Mat(frame.y.height, frame.y.width, CV_8UC1, pixels, static_cast<std::size_t>(frame.y.stride));
}

} // namespace odo
