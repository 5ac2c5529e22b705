// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <cstring>
#include <memory>
#include <opencv2/core/mat.hpp>

/// A frame with this luma, grey.
inline odo::Frame frameOf(const cv::Mat &luma)
{
    odo::FrameFormat format;
    format.width = luma.cols;
    format.height = luma.rows;
    auto buffer = std::make_shared<odo::FrameBuffer>(format);
    for (int y = 0; y < luma.rows; ++y)
        std::memcpy(buffer->yRow(y), luma.ptr(y), static_cast<std::size_t>(luma.cols));
    return odo::FrameBuffer::toFrame(buffer, 0, odo::Nanoseconds(0));
}
