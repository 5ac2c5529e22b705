// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/tag_alignment.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/camera_model.h"
#include "core/video/frame.h"

#include <optional>
#include <vector>

namespace odo {

/// An AprilTag 36h11 in an image.
struct SeenTag
{
    int number = 0;
    Eigen::Vector2d pixel; ///< where the diagonals cross: the image of its middle
    double sigmaPx = 0;    ///< of one coordinate of it
    /// From the tag's plane: its black square goes from (-1, -1) at the top left of its print to (1, 1).
    Eigen::Matrix3d pixelFromTag;
};

/// The cells of a tag. number: 0 to 586.
TagCells tagCells(int number);

/// All tags of an image, or of a part of it, in luma pixels of the whole: read by libapriltag, then each
/// aligned with all of its cells (alignTag). Tags that do not match the image are left out. Read in the image
/// reduced to 12 megapixels where it has more. None where a side has more than 32767 pixels then.
/// Thread-safe.
std::vector<SeenTag> findTags(const Frame &frame, std::optional<PixelRect> part = {});

/// Tags smaller than findTags reads, from an image twice as large, for sides half as long, but of 24
/// megapixels at most. Two to four times its work. Thread-safe.
std::vector<SeenTag> findSmallTags(const Frame &frame, std::optional<PixelRect> part = {});

/// Tags of a layout that could not be read, being too small or too flat in the image, found by prediction
/// from the read ones: those give the camera pose, the tags' size and their turn (least squares over their
/// corners); each missing one is then aligned at its predicted position (alignTag), in all four quarter
/// turns, and kept if the image matches its cells. read: two or more of the layout's tags, numbered by their
/// index in it. camera: to be relied on; without one four read tags are needed, from which the focal length
/// is estimated. Thread-safe.
std::vector<SeenTag> predictedTags(const Frame &frame, const MarkerLayout &layout,
                                   const std::vector<SeenTag> &read,
                                   const std::optional<CameraModel> &camera);

} // namespace odo
