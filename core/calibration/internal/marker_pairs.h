// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/homography.h"

#include <span>
#include <vector>

namespace odo {

/// The floor positions of pairs, in their order. Metres.
std::vector<Eigen::Vector2d> positionsOf(std::span<const PointPair> pairs);

/// "the floor cannot be registered", why, and what to do.
tl::unexpected<Error> refuseFloor(Message why, Message advice, ErrorCode code = ErrorCode::Undetermined);

/// Floor positions (source, metres) with their pixels (target) of the markers that layout and image have in
/// common, in the layout's order. Refuses by name: fewer than four, doubled labels, values that are no
/// numbers.
Result<std::vector<PointPair>> commonMarkers(const MarkerLayout &layout,
                                             const std::vector<MarkerPixel> &pixels);

/// Refuses markers that share a floor position or a pixel, and two of four that are too close to count.
Result<void> checkDistances(const std::vector<PointPair> &pairs, double extentM);

} // namespace odo
