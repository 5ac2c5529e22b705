// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/bit_mask.h"

#include <vector>

namespace odo {

/// Pixels of a row from x0 up to, not including, x1.
struct PixelRun
{
    int y = 0, x0 = 0, x1 = 0;
};

/// Pixels that hang together: their runs from top to bottom, each row's from left to right.
using ConnectedPart = std::vector<PixelRun>;

/// The parts of a set, the one with the topmost pixel first. Pixels that only touch at a corner hang together. Pure.
std::vector<ConnectedPart> connectedParts(const BitMask &set);
PixelRect boundsOf(const ConnectedPart &part);
bool contains(const ConnectedPart &part, int x, int y);

/// Whether a part encloses pixels that do not belong to it. Pure.
bool enclosesAny(const ConnectedPart &part);
/// The set and all of the image that it encloses. Pure.
BitMask withoutHoles(const BitMask &set);

} // namespace odo
