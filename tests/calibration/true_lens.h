// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"

#include <utility>
#include <vector>

namespace odo::test {

/// The true lens of the calibration tests, of 1280×720 pixels; as it is, one of ordinary distortion.
inline Intrinsics trueLens(LensModel model = LensModel::Standard,
                           std::vector<double> distortion = {-0.2, 0.06, 0.0005, -0.0003, 0})
{
    return {1280, 720, 902.5, 905.5, 651.25, 348.5, model, std::move(distortion), {}};
}

inline CameraModel trueCamera()
{
    return CameraModel::create(trueLens()).value();
}

} // namespace odo::test
