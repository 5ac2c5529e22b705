// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/camera_model.h"
#include "core/video/frame.h"

#include <optional>
#include <vector>

namespace odo {

/// What is known before the markers are looked for.
struct MarkerSearch
{
    std::optional<CameraModel> camera; ///< of the frame's size; without it one free of distortion is assumed
    bool intrinsicsKnown = false;      ///< the camera's focal length is to be relied on
    /// Markers told by hand; a pixel within 20 px of a shape means that shape.
    std::vector<MarkerPixel> hints;
};

/// Finds the floor markers of a layout in a picture, in the layout's order. First tags, a tag's number being
/// the place of its label in the layout (first marker: tag 0, ...); where fewer than four of them are seen,
/// rings and dots as well, told apart as assignMarkers() says. The pixel is the picture of the marker's
/// middle, not the middle of its picture. Error Undetermined, naming how many of how many were found, when
/// fewer than four are seen, and as assignMarkers.
Result<std::vector<MarkerPixel>> findMarkers(const Frame &frame, const MarkerLayout &layout,
                                             const MarkerSearch &search = {});

} // namespace odo
