// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"

#include <opencv2/core/mat.hpp>

namespace odo {

/// findBoard for BoardPattern::Checkerboard. A board of a told size of which rows or columns lie outside the
/// picture is taken with the corners that are in it (two thirds at least).
Result<BoardView> findCheckerboard(const cv::Mat &luma, const BoardSpec &spec, const std::string &source);

} // namespace odo
