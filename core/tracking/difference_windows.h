// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/bit_mask.h"

#include <vector>

namespace odo {

/// Where to look closer, luma pixels.
struct DifferenceWindow
{
    /// Columns from the window's left edge, begin up to, not including, end.
    struct Band
    {
        int begin = 0, end = 0;         ///< to be read
        int safeBegin = 0, safeEnd = 0; ///< where pixels count; what is within safePx of them is read, too
    };
    static constexpr int safePx = 4;

    PixelRect rect;
    std::vector<Band> bands; ///< of DifferenceLattice::step rows each, from the top
};

/// Windows around what differs on a lattice (core/tracking/difference_lattice.h), which do not overlap; in groups of those that are near one another, as a
/// robot and its shadow may be. Single samples are noise and get none. Pure.
std::vector<std::vector<DifferenceWindow>> windowsAround(const BitMask &differences, const PixelRect &picture);

} // namespace odo
