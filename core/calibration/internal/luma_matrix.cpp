// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/luma_matrix.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace odo {

double searchScale(const cv::Mat &luma)
{
    return std::min(1.0, std::sqrt(mostSearchedPixels / (double(luma.cols) * luma.rows)));
}

cv::Mat reduced(const cv::Mat &luma, double scale)
{
    cv::Mat image = luma;
    if (scale != 1)
        cv::resize(luma, image, {}, scale, scale, cv::INTER_AREA);
    return image;
}

} // namespace odo
