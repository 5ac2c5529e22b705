// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/corner_outliers.h"
#include "core/calibration/intrinsic_calibration.h"

namespace odo {

/// One lens model fitted to all views.
struct LensChoice
{
    LensFit fit;
    CornerMarks outliers;          ///< that stand out from that fit
    std::vector<LensTrial> trials; ///< empty where there was one start only
    std::string reason;            ///< as IntrinsicCalibration::lensReason
};

/// "standard", "rational", "fisheye"
std::string lensModelName(LensModel model);

/// Fits each start's model and takes the first that foretells held-out pictures about as well as the best one does, as
/// calibrateIntrinsics says. starts: the plainest model first. Corners that stand out from every model are not asked.
/// nullopt where none fits or it was cancelled.
std::optional<LensChoice> chooseLens(const std::vector<BoardView> &views, const std::vector<LensStart> &starts,
                                     const JobControl &control);

} // namespace odo
