// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/frame.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace odo {

/// Reads a still image (PNG, JPEG, TIFF, HEIC and AVIF, WebP, BMP, PNM; by its content, whatever its name) as
/// a full-range frame by BT.601: a JPEG's planes and a grey image's luma as they are, colours as 4:4:4. It is
/// turned as it says it is to be shown, and Frame::orientation says how: inOrientation(frame, 1) gives the
/// sensor's own rows and columns. Refuses more than 50 megapixels or 32000 pixels a side before decoding. Any
/// thread.
Result<Frame> readImage(const std::filesystem::path &file);

enum class ImageFormat { Png, Jpeg, Bmp, Tiff, Pbm, Pgm, Ppm, Webp, Heif };

struct ImageHeader
{
    ImageFormat format = ImageFormat::Png;
    std::uint32_t width = 0, height = 0;
};

/// Whether the first bytes of a file (32 are enough) are those of a still image that readImage knows,
/// whatever the rest is.
bool startsAsImage(std::span<const std::uint8_t> file);

/// Format, width and height that the header of a still image states, without decoding it and before it is
/// turned; of a TIFF in tiles at least those of a tile. Strict, so that no decoder finds a larger
/// image than is stated here: nullopt for anything else, for headers that end early, and for those that can
/// be read in two ways. Never reads outside `file`.
std::optional<ImageHeader> imageHeader(std::span<const std::uint8_t> file);

} // namespace odo
