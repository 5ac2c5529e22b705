// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmark/metrics.h"

namespace odo::test {

/// The calibration of a camera from 60 pictures of 54 corners (noise of 0.1 px) beside cv::calibrateCamera,
/// CPU time, medians of so many rounds: with the lens model told (fit, halves, outliers, checks and all),
/// with it chosen, and again after a threshold was moved; and the RMS of both.
std::vector<Measurement> measureCalibration(int rounds);

} // namespace odo::test
