// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace odo {

/// How the picture of a JPEG file (ITU-T T.81) lies in planes, by its header alone: full range, chroma
/// centred (JFIF). nullopt where the header is damaged or the picture has not luma and two planes of equal
/// chroma. Any thread.
std::optional<FrameFormat> jpegFormat(std::span<const std::uint8_t> jpeg);

/// The same file with the standard Huffman tables (ITU-T T.81, Annex K.3) put in where it has none, as USB
/// cameras leave them out. A file that has its tables, or whose header is damaged, comes back as it is. Any
/// thread.
std::vector<std::uint8_t> withHuffmanTables(std::span<const std::uint8_t> jpeg);

} // namespace odo
