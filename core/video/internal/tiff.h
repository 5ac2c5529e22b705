// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"
#include "core/video/internal/header_number.h"

#include <cstdint>
#include <optional>
#include <span>

namespace odo {

/// By the first image file directory (TIFF 6.0 §2): ImageWidth 256, ImageLength 257, TileWidth 322,
/// TileLength 323, each of them once and SHORT or LONG. What is stated otherwise is refused: which size a
/// decoder takes then is its choice.
StatedSize tiffSize(std::span<const std::uint8_t> file);

/// Whether its pixels are numbers without a sign (SampleFormat 339 is 1 or not there), and its first
/// directory is that of the image itself: raw formats of cameras have a preview there (SubIFDs 330,
/// NewSubfileType 254).
bool hasPlainPixels(std::span<const std::uint8_t> file);

/// The first image of the file by libtiff (strips, tiles, all compressions of cameras and programs), as a
/// full-range frame by BT.601 in the order of its rows; nullopt where it is damaged or of no known kind.
std::optional<Frame> decodeTiff(std::span<const std::uint8_t> file);

} // namespace odo
