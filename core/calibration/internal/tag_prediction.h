// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/tag_detection.h"
#include "core/geometry/camera_model.h"

#include <optional>
#include <span>
#include <vector>

namespace odo {

/// A tag whose middle has a known floor position, metres.
struct FloorTag
{
    TagName name;
    Eigen::Vector2d pointInWorld;
};

/// Tags of the floor that could not be read, being too small or too flat in the image, found by prediction
/// from the read ones: those give the camera pose, the tags' size and their turn (least squares over their
/// corners); each missing one is then aligned at its predicted position (alignTag), in all four quarter
/// turns, and kept if the image matches its cells. read: two or more of the tags, each once. camera: to be
/// relied on; without one four read tags are needed, from which the focal length is estimated. Thread-safe.
std::vector<SeenTag> predictedTags(const Frame &frame, std::span<const FloorTag> tags,
                                   const std::vector<SeenTag> &read,
                                   const std::optional<CameraModel> &camera);

} // namespace odo
