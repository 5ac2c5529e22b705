// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

namespace odo {

/// Asks for some bytes to be brought near the processor, before they are read.
inline void fetchEarly(const std::uint8_t *bytes, int count)
{
    constexpr int cacheLine = 64;
    for (int i = 0; i < count; i += cacheLine)
        __builtin_prefetch(bytes + i);
    __builtin_prefetch(bytes + count - 1);
}

/// Asks for a part of a plane (in its own samples, inside of it) to be brought near the processor. A decoder
/// leaves most of a frame in far memory, and the rows of a part of it are too short for the processor to
/// predict: waiting for one after the other costs as much as all the work on them.
inline void fetchEarly(const PlaneView &plane, const PixelRect &part)
{
    for (int y = part.y0; y < part.y1; ++y)
        fetchEarly(plane.row(y) + part.x0, part.width());
}

} // namespace odo
