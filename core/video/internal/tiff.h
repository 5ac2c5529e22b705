// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/internal/header_number.h"

#include <cstdint>
#include <span>

namespace odo {

/// By the first image file directory (TIFF 6.0 §2): ImageWidth 256, ImageLength 257, TileWidth 322,
/// TileLength 323, each of them once and SHORT or LONG. What is stated otherwise is refused: which size a
/// decoder takes then is its choice.
StatedSize tiffSize(std::span<const std::uint8_t> file);

/// Takes the tags off the first directory that say nothing of the pixels (who made it, when, which way up):
/// libavcodec, when it is to report damage, takes each that it does not know for damage. Never writes outside
/// `file`.
void keepPixelTags(std::span<std::uint8_t> file);

} // namespace odo
