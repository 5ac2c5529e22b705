// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/camera_pair.h"
#include "core/calibration/internal/pair_start.h"

#include <vector>

namespace odo {

/// Pairs with the board's pose by each camera alone, without misread corners.
struct PosedPairs
{
    std::vector<PosedPair> pairs;
    std::vector<std::size_t> leftOut; ///< of each pair: misread corners in both images
    std::vector<double> squares;      ///< of each pair: what its corners leave in each image alone, px²
    double sigmaPx = 0;               ///< of one coordinate of a corner, from these
};

/// Those that have the board in both images and a pose in each, the misread corners of each camera left out
/// (misreadCorners); the others go to rejected. InvalidInput where the images of each camera fit the lens of
/// the other one better.
Result<PosedPairs> posedPairs(const std::vector<BoardPair> &pairs, const CameraModel &a, const CameraModel &b,
                              std::vector<RejectedPair> &rejected, const JobControl &control);

} // namespace odo
