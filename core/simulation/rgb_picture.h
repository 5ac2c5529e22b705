// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace odo {

/// Whole pixels from (x0, y0) up to, not including, (x1, y1).
struct PixelRect
{
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    bool isEmpty() const { return x1 <= x0 || y1 <= y0; }
    bool meets(const PixelRect &other) const
    {
        return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
    }
    PixelRect united(const PixelRect &other) const
    {
        return {std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1),
                std::max(y1, other.y1)};
    }
    PixelRect clipped(const PixelRect &other) const
    {
        return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1),
                std::min(y1, other.y1)};
    }
};

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
