// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/internal/round_markers.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/camera_model.h"

#include <vector>

namespace odo {

/// Finds which shape of an image is which marker, by geometry alone: of all ways to give shapes to the
/// layout's labels that a camera above the floor can see, the one that fits best and with the most markers.
/// Shapes that are no markers are left over; markers may be hidden as long as four are seen. Rings are tried
/// first; where they are not all of the layout, dots as well. Twelve markers or more are assigned from
/// neighbour to neighbour (growAssignments), where half of those in the image must be seen, and eight;
/// up to 24 by fours as well.
///
/// hints: labels that are known already (tags, or clicked by a person): the shape within 20 px of the pixel
/// gets the label, or, where there is none, the pixel itself is taken. intrinsicsKnown = false: the focal
/// length is free, and four markers fit in nearly any order; mark one or two by hand.
///
/// Undetermined: too few shapes, none fits, or the layout looks the same from several sides (a rectangle from
/// two, a square from four): then the message names the marker to mark by hand. Thread-safe.
Result<std::vector<MarkerPixel>> assignMarkers(const std::vector<RoundMarker> &shapes,
                                               const MarkerLayout &layout, const CameraModel &camera,
                                               bool intrinsicsKnown,
                                               const std::vector<MarkerPixel> &hints = {});

} // namespace odo
