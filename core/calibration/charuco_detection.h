// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"

#include <opencv2/core/mat.hpp>

namespace odo {

/// findBoard for BoardPattern::Charuco. Boards that are printed inverted (bright markers on dark) are found
/// as well, and both ways of laying out a board with an even number of rows (OpenCV changed it in 4.6). An
/// inner corner counts when both markers beside it were read.
Result<BoardView> findCharucoBoard(const cv::Mat &luma, const BoardSpec &spec, const std::string &source);

} // namespace odo
