// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/video/pixel_rect.h"

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace odo {

/// Red, green, blue in 0..255 and unused; a colour of the sensor's linear range.
using Rgb = Eigen::Array4f;

inline Rgb toRgb(const RgbColour &colour)
{
    return {static_cast<float>(colour.red), static_cast<float>(colour.green), static_cast<float>(colour.blue),
            0.f};
}

/// Full-resolution colour of a part of a picture.
class RgbPicture
{
public:
    explicit RgbPicture(const PixelRect &rect)
        : m_rect(rect),
          m_pixels(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()))
    {
    }

    const PixelRect &rect() const { return m_rect; }
    /// The pixels of row y of the whole picture, from rect().x0 on.
    Rgb *row(int y) { return m_pixels.data() + static_cast<std::ptrdiff_t>(y - m_rect.y0) * m_rect.width(); }
    const Rgb *row(int y) const
    {
        return m_pixels.data() + static_cast<std::ptrdiff_t>(y - m_rect.y0) * m_rect.width();
    }
    /// A copy of a part, which must lie inside.
    RgbPicture part(const PixelRect &rect) const
    {
        RgbPicture copy(rect);
        for (int y = rect.y0; y < rect.y1; ++y)
            std::copy_n(row(y) + (rect.x0 - m_rect.x0), rect.width(), copy.row(y));
        return copy;
    }

private:
    PixelRect m_rect;
    std::vector<Rgb> m_pixels;
};

} // namespace odo
