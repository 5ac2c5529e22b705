// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/accuracy_map.h"

#include <string>
#include <vector>

namespace odo {

/// What a map of σ says of the floor among the markers (the rectangle about them). Metres.
struct AccuracySummary
{
    double middleM = 0; ///< in its middle; NaN where that is not seen
    double worstM = 0;  ///< where it is largest; NaN where nothing is seen
    double seenPart = 0;
    std::string words;  ///< "±1.8 mm in the middle, ±6.0 mm in the corner near D." and what is not seen
};

/// sigmaM: one value a place of the grid, NaN where it is not seen. Pure; any thread.
AccuracySummary summariseAccuracy(const FloorGrid &grid, const std::vector<double> &sigmaM, const MarkerLayout &layout);

} // namespace odo
