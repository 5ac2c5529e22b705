// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

namespace odo {

/// A look at rows of packed colours of 8 bits, three bytes a pixel.
struct RgbView
{
    enum class Order { Rgb, Bgr };
    const std::uint8_t *data = nullptr;
    int width = 0, height = 0;
    std::ptrdiff_t stride = 0; ///< bytes from one row to the next
    Order order = Order::Rgb;
};

/// Planes of a picture of packed colours: luma at full size, U and V the mean of each 2×2 pixels, so that
/// they lie in their middle (siting Center; of an odd last column or row, of what there is); full range,
/// BT.601 as JFIF 1.02 defines it. Any thread.
Frame rgbPlanes(const RgbView &picture, std::int64_t index, Nanoseconds time);

/// Planes of a picture without colours: luma as it is, no chroma (128, 4:2:0); full range. Any thread.
Frame monoPlanes(const PlaneView &picture, std::int64_t index, Nanoseconds time);

} // namespace odo
