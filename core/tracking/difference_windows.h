// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/bit_mask.h"

#include <vector>

namespace odo {

/// Windows of luma pixels around what differs on a lattice (core/tracking/difference_lattice.h), which do not overlap; in groups of those that are near
/// one another, as a robot and its shadow may be. Single samples are noise and get none. Pure.
std::vector<std::vector<PixelRect>> windowsAround(const BitMask &differences, const PixelRect &picture);

} // namespace odo
