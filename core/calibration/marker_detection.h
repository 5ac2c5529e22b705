// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/video/frame.h"

#include <vector>

namespace odo {

/// Finds the floor markers of a layout in a picture. A marker is an AprilTag 36h11 whose number is the place of the
/// label in the layout (first marker: tag 0, second: tag 1, ...); its centre is the marker's point.
/// Error Undetermined, naming how many of how many were found, when fewer than four are seen.
Result<std::vector<MarkerPixel>> findMarkers(const Frame &frame, const MarkerLayout &layout);

} // namespace odo
