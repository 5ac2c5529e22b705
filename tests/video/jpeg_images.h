// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <vector>

namespace odo::test {

struct JpegWay
{
    bool progressive = false, grey = false;
    int restartRows = 0; ///< rows of blocks between restart markers
};

/// A picture full of detail, coded by libjpeg with the standard Huffman tables.
std::vector<std::uint8_t> jpegOf(const FrameFormat &format, const JpegWay &way);
/// The same picture as a USB camera would send it.
std::vector<std::uint8_t> withoutHuffmanTables(const std::vector<std::uint8_t> &jpeg);
/// What libavcodec makes of it; no planes when it refuses.
Frame decodedByLibavcodec(const std::vector<std::uint8_t> &jpeg, const FrameFormat &format);

} // namespace odo::test
