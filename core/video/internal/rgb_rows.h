// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

namespace odo {

/// Of a still image that was made from red, green and blue: 4:4:4, full range, BT.601.
inline FrameFormat rgbFormat(int width, int height)
{
    FrameFormat format;
    format.width = width;
    format.height = height;
    format.chromaShiftX = format.chromaShiftY = 0;
    format.siting = ChromaSiting::Center;
    format.fullRange = true;
    return format;
}

/// BT.601 at full range as JFIF 1.02 defines it, in 16-bit fixed point. Three bytes a pixel.
inline void convertRgbRow(const std::uint8_t *rgb, int width, std::uint8_t *y, std::uint8_t *u,
                          std::uint8_t *v)
{
    constexpr int half = 1 << 15, middle = (128 << 16) + half - 1; // -1 keeps pure blue and red at 255
    for (int x = 0; x < width; ++x, rgb += 3) {
        const int r = rgb[0], g = rgb[1], b = rgb[2];
        y[x] = static_cast<std::uint8_t>((19595 * r + 38470 * g + 7471 * b + half) >> 16);
        u[x] = static_cast<std::uint8_t>((-11059 * r - 21709 * g + 32768 * b + middle) >> 16);
        v[x] = static_cast<std::uint8_t>((32768 * r - 27439 * g - 5329 * b + middle) >> 16);
    }
}

} // namespace odo
