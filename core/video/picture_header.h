// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace odo {

enum class PictureFormat { Png, Jpeg, Bmp, Tiff, Pbm, Pgm, Ppm };

struct PictureHeader
{
    PictureFormat format = PictureFormat::Png;
    std::uint32_t width = 0, height = 0;
};

/// Format, width and height that the header of a still picture states, without decoding it: PNG, JPEG, BMP,
/// TIFF and PNM; of a TIFF in tiles at least those of a tile. Strict, so that no decoder finds a larger
/// picture than is stated here: nullopt for anything else, for headers that end early, and for those that can
/// be read in two ways. Never reads outside `file`.
std::optional<PictureHeader> pictureHeader(std::span<const std::uint8_t> file);

} // namespace odo
