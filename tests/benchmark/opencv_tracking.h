// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmark/clip_tracking.h"

#include <opencv2/core.hpp>

namespace odo::test {

/// A frame's planes one below the other, as OpenCV wants them.
cv::Mat stackedPlanes(const Frame &frame);

/// The ordinary way, as OpenCV's own example goes (samples/cpp/camshiftdemo.cpp): the whole frame from BGR to
/// HSV, the back projection of a histogram of hue and saturation over it, CamShift. Its histogram is taken
/// from the true place in the first frame.
struct OpencvTrackedClip
{
    TrackedClip tracked;        ///< afterS: HSV, back projection and CamShift only
    double toBgrS = 0;          ///< from the decoder's planes to BGR, not in afterS
    double backProjectionS = 0; ///< of afterS; of all robots
};
OpencvTrackedClip trackByOpencv(const BenchmarkClip &clip, std::size_t robots);

} // namespace odo::test
