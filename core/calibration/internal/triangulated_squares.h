// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/camera_pair.h"
#include "core/calibration/internal/pair_fit.h"

#include <span>

namespace odo {

/// The corners that both images of a pair have, each triangulated for itself by the relation (the point whose
/// pixels are nearest to those seen, Gauss–Newton from the board's pose), and the distances of neighbours. Of
/// the board only its rows and columns count, not its flatness or the size of its squares.
TriangulatedSquares triangulatedSquares(std::span<const PairedBoards> pairs, const CameraModel &a,
                                        const CameraModel &b, const PairFit &fit);

} // namespace odo
