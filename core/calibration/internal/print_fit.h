// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/outlier_corners.h"

#include <optional>

namespace odo {

/// A print of equal squares on a plane, of the board that the views show.
BoardShape plainPrintOf(const std::vector<BoardView> &views);

/// The fit with the print's shape estimated, where that predicts held-out images clearly better than a board
/// of equal squares on a plane does (predictsClearlyWorse); nullopt otherwise, and under six views. Misread
/// corners take no part in that decision.
std::optional<LensFit> fitWithPrint(const std::vector<BoardView> &views, const CornerMarks &misread,
                                    const LensFit &flat, const JobControl &control);

/// The factor by which the scatter of the images' pulls finds σ of the focal length or of the centre larger
/// than the fit states, where that is more than chance explains; otherwise 1.
double scatterFactor(const LensFit &fit);

} // namespace odo
