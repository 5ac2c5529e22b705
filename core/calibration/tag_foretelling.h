// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"
#include "core/calibration/tag_detection.h"
#include "core/geometry/camera_model.h"

namespace odo {

/// Tags of a layout that could not be read, being too small or too flat in the picture, found by what the
/// read ones foretell: those tell where the camera stands, how large the tags are and how they are turned
/// (least squares over their corners); each missing one is then laid over the picture there (alignTag), in
/// all four quarter turns, and taken where the picture is like its cells. read: two or more of the layout's
/// tags, numbered by their place in it. camera: to be relied on; without one four read tags are needed, from
/// which the focal length is estimated. Thread-safe.
std::vector<SeenTag> foretoldTags(const Frame &frame, const MarkerLayout &layout,
                                  const std::vector<SeenTag> &read, const std::optional<CameraModel> &camera);

} // namespace odo
