// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"

namespace odo {

/// How much a lens may differ from its values where nothing says how sure they are, one σ each. The focal
/// length counts relative to itself, its difference between the axes too; the principal point relative to the
/// longer side; k1 as it is.
struct LensSpread
{
    double focal, aspect, centre, k1;
};

/// A lens that nobody calibrated: the ordinary spread of webcams, phones and action cameras.
inline constexpr LensSpread assumedLensSpread{0.5, 0.01, 0.02, 0.2};

/// A calibration without a stated uncertainty, as other programs write them: imported ones of webcams and of
/// machine vision cameras were found 0.1 to 1 % off.
inline constexpr LensSpread importedLensSpread{0.01, 0.001, 0.005, 0.02};

/// A lens bent inwards by k1 is bent back by k2, ordinarily by this times k1.
inline constexpr double k2ByK1 = -0.35;

/// Covariance of (fx, fy, cx, cy, distortion...); coefficients beyond the first count as exact.
Eigen::MatrixXd covarianceOf(const Intrinsics &lens, const LensSpread &spread);

} // namespace odo
