// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/calibration/board_detection.h"
#include "core/geometry/camera_model.h"

#include <string>
#include <utility>
#include <vector>

namespace odo {

struct RejectedPicture
{
    std::string file;
    std::string reason;
};

/// The outcome of a calibration, as the command line prints it.
struct IntrinsicCalibration
{
    Intrinsics intrinsics;
    double rmsPx = 0;                                       ///< over all corners, sqrt(mean of squared distances)
    std::vector<std::pair<std::string, double>> pictureRmsPx;
    std::vector<RejectedPicture> rejected;
    double crossValidationPx = 0; ///< RMS of each half's corners under the other half's intrinsics; 0 under 6 views
    std::string verdict;          ///< one sentence for a person
};

/// Zhang 2000 with Levenberg–Marquardt refinement (Ceres), all views jointly. Refuses fewer than three views and views
/// that do not determine the focal length (all frontal or all of one pose).
Result<IntrinsicCalibration> calibrateIntrinsics(const std::vector<BoardView> &views, int widthPx, int heightPx,
                                                 LensModel model, const JobControl &control);

} // namespace odo
