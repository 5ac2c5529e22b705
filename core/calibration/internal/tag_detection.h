// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/tag_families.h"
#include "core/video/frame.h"

#include <optional>
#include <span>
#include <vector>

namespace odo {

/// A tag in an image.
struct SeenTag
{
    int number = 0;
    TagFamily family = TagFamily::AprilTag36h11;
    Eigen::Vector2d pixel; ///< where the diagonals cross: the image of its middle
    double sigmaPx = 0;    ///< of one coordinate of it
    /// From the tag's plane: its border square goes from (-1, -1) at the top left of its print to (1, 1).
    Eigen::Matrix3d pixelFromTag;
    double contrast = 0; ///< grey values between black and white
};

/// All tags of these families in an image, or in a part of it, in luma pixels of the whole: read by
/// libapriltag, then each aligned with all of its cells (alignTag). Tags that do not match the image are left
/// out. Read in the image reduced to 12 megapixels where it has more. None where a side has more than 32767
/// pixels then. Thread-safe.
std::vector<SeenTag> findTags(const Frame &frame, std::optional<PixelRect> part = {},
                              std::span<const TagFamily> families = printedTagFamily());

/// Tags smaller than findTags reads, from an image twice as large, for sides half as long, but of 24
/// megapixels at most. Two to four times its work. Thread-safe.
std::vector<SeenTag> findSmallTags(const Frame &frame, std::optional<PixelRect> part = {},
                                   std::span<const TagFamily> families = printedTagFamily());

} // namespace odo
