// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/lens_fit.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/calibration/repeated_views.h"

#include <optional>
#include <vector>

namespace odo {

/// With fewer there is no calibration.
constexpr std::size_t leastViews = 3;

/// What a calibration is solved from.
struct CalibrationEvidence
{
    std::vector<BoardView> views; ///< those that count, one a position of the board
    std::vector<LensStart> starts;
};

/// Fills in the calibration's images and what it rejects. model: the one asked for, if any.
CalibrationEvidence evidenceFrom(const std::vector<BoardView> &views, int widthPx, int heightPx,
                                 std::optional<LensModel> model, IntrinsicCalibration &calibration);

/// Leaves out the images that contradict the others (oddImages).
void dropOddImages(CalibrationEvidence &evidence, IntrinsicCalibration &calibration,
                   const JobControl &control);

/// Why a view does not count, a clause: it shows the board in the position of another one. Empty of a view
/// that counts.
Message repeatOf(const std::vector<BoardView> &views, const BoardPositions &positions, std::size_t index);

} // namespace odo
