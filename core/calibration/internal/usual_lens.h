// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"

namespace odo {

/// What is known of a standard lens before any image, as residuals A·(x − x₀) of its values x = (fx, fy, cx,
/// cy, k1, k2, p1, p2, k3): square pixels, an optical centre near the image's middle and a distortion as
/// webcams, phones and action cameras have it. It says nothing about the focal length.
struct UsualLens
{
    Eigen::MatrixXd weights; ///< A, each row of σ sigmaPx
    Eigen::VectorXd values;  ///< x₀
};

/// lens: its size in pixels, and about its focal length. sigmaPx: of one coordinate of a corner, beside whose
/// residuals these stand.
UsualLens usualLens(const Intrinsics &lens, double sigmaPx);

} // namespace odo
