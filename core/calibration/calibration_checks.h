// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/held_out.h"

namespace odo {

/// What the messages of a calibration begin with.
inline constexpr const char *calibrationWhat = "the camera cannot be calibrated";

tl::unexpected<Error> refuseCalibration(std::string why, std::string advice);

/// "0.20 %"
std::string percentWords(double part);

/// The part of the picture that the box about all corners covers.
double boxOfCorners(const std::vector<BoardView> &views, int widthPx, int heightPx);

/// Where in the picture the middle of all corners lies: "upper left", "middle".
std::string placeOfCorners(const std::vector<BoardView> &views, int widthPx, int heightPx);

/// Refuses pictures that show the board always in the same part of the picture.
Result<void> checkPlaces(const std::vector<BoardView> &views, int widthPx, int heightPx);

/// Refuses pictures that fall into two groups which are fitted far better by a lens each, of different focal lengths.
Result<void> checkOneCamera(const std::vector<BoardView> &views, const LensFit &fit, const JobControl &control);

/// Refuses a fit that its pictures do not determine, and gives σ of its focal length over itself otherwise.
Result<double> checkDetermined(const std::vector<BoardView> &views, const LensFit &fit,
                               const std::optional<HeldOut> &halves, const JobControl &control);

} // namespace odo
