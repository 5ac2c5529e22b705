// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace odo {

/// Whole luma pixels from (x0, y0) up to, not including, (x1, y1).
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
    bool contains(const PixelRect &other) const
    {
        return x0 <= other.x0 && other.x1 <= x1 && y0 <= other.y0 && other.y1 <= y1;
    }
    /// The smallest rectangle that holds both; an empty one adds nothing.
    PixelRect united(const PixelRect &other) const
    {
        if (isEmpty())
            return other;
        if (other.isEmpty())
            return *this;
        return {std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1),
                std::max(y1, other.y1)};
    }
    PixelRect clipped(const PixelRect &other) const
    {
        return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1),
                std::min(y1, other.y1)};
    }
};

} // namespace odo
