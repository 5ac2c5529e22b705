// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/tag_alignment.h"
#include "core/video/frame.h"

#include <optional>
#include <vector>

namespace odo {

/// An AprilTag 36h11 in a picture.
struct SeenTag
{
    int number = 0;
    Eigen::Vector2d pixel; ///< where the diagonals cross: the picture of its middle
    double sigmaPx = 0;    ///< of one coordinate of it
    /// From the tag's plane: its black square goes from (-1, -1) at the top left of its print to (1, 1).
    Eigen::Matrix3d pixelFromTag;
};

/// The cells of a tag. number: 0 to 586.
TagCells tagCells(int number);

/// All tags of a picture, or of a part of it, in luma pixels of the whole: read by libapriltag, then each
/// laid over the picture with all of its cells (alignTag). Tags whose picture is not like them are left out.
/// Read in the picture reduced to 12 megapixels where it has more. None where a side has more than 32767 pixels then. Thread-safe.
std::vector<SeenTag> findTags(const Frame &frame, std::optional<PixelRect> part = {});

/// Tags smaller than findTags reads, from a picture twice as large, for sides half as long, but of 24 megapixels at most. Two to four
/// times its work. Thread-safe.
std::vector<SeenTag> findSmallTags(const Frame &frame, std::optional<PixelRect> part = {});

} // namespace odo
