// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/intrinsic_calibration.h"

namespace odo {

/// The sentences of IntrinsicCalibration::verdict from all else in it. focalSigma: of the focal length over itself.
std::string calibrationVerdict(const IntrinsicCalibration &calibration, double focalSigma);

} // namespace odo
