// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

namespace odo {

/// Asks for a part of a plane (in its own samples, inside of it) to be brought near the processor. A decoder
/// leaves most of a picture in far memory, and the rows of a part of it are too short for the processor to
/// foresee: waiting for one after the other costs as much as all the work on them.
inline void fetchEarly(const PlaneView &plane, const PixelRect &part)
{
    constexpr int cacheLine = 64;
    for (int y = part.y0; y < part.y1; ++y) {
        const std::uint8_t *row = plane.row(y);
        for (int x = part.x0; x < part.x1; x += cacheLine)
            __builtin_prefetch(row + x);
        __builtin_prefetch(row + part.x1 - 1);
    }
}

} // namespace odo
