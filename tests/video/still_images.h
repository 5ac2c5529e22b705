// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Still images in memory, as cameras and programs write them, coded by the libraries that those use.

namespace odo::test {

struct RgbImage
{
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb; ///< three bytes a pixel, rows without padding

    const std::uint8_t *at(int x, int y) const
    {
        return &rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
    }
    int grey(int x, int y) const ///< luma by BT.601
    {
        const std::uint8_t *pixel = at(x, y);
        return int(0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2] + 0.5);
    }
};

/// Four coloured quarters with a soft slope, none of them like another: which way up it is can be told.
RgbImage fourQuarters(int width, int height);

/// The image as a camera would have stored it that notes this EXIF orientation, by the standard's own words
/// on where the first row and the first column are (CIPA DC-008, tag 274).
RgbImage storedFor(const RgbImage &shown, int orientation);

using Bytes = std::vector<std::uint8_t>;

/// By an encoder of libavcodec, in one of its pixel formats; `options` as "compression_algo=lzw". Empty where
/// it refuses.
Bytes codedByLibav(const RgbImage &image, const std::string &encoder, const std::string &pixelFormat,
                   const std::string &options = {});
/// By libheif, with its boxes for this orientation. Empty where it has no encoder.
Bytes heicOf(const RgbImage &image, int orientation = 1);
/// In tiles of 64 by 64 pixels, packed by LZW, by libtiff.
Bytes tiledTiffOf(const RgbImage &image);
/// By libjpeg in four inks, as image editors write it: inverted, and with Adobe's mark; `isYcck` as
/// Photoshop.
Bytes cmykJpegOf(const RgbImage &image, bool isYcck, bool isProgressive);

/// The same file with EXIF that states an orientation.
Bytes jpegWithOrientation(const Bytes &jpeg, int orientation, bool bigEndian);
Bytes pngWithOrientation(const Bytes &png, int orientation);
Bytes webpWithOrientation(const Bytes &webp, const RgbImage &image, int orientation);

} // namespace odo::test
