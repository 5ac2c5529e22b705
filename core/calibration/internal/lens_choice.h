// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/outlier_corners.h"
#include "core/calibration/intrinsic_calibration.h"

namespace odo {

/// One lens model fitted to all views.
struct LensChoice
{
    LensFit fit;
    CornerMarks outliers;           ///< outliers of that fit
    std::vector<ModelTrial> trials; ///< empty where there was one start only
    Message reason;                 ///< as IntrinsicCalibration::modelReason
};

/// "standard", "rational", "fisheye"
Message lensModelName(LensModel model);

/// Fits each start's model and takes the first that predicts held-out images about as well as the best, as
/// calibrateIntrinsics says. starts: the plainest model first. Outliers of every model do not count. nullopt
/// where none fits or it was cancelled.
std::optional<LensChoice> chooseLens(const std::vector<BoardView> &views,
                                     const std::vector<LensStart> &starts, const JobControl &control);

} // namespace odo
