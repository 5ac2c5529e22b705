// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/bit_mask.h"
#include "core/tracking/searched_area.h"

namespace odo {

/// A lattice of samples over a frame.
struct SampleLattice
{
    int columns = 0, rows = 0;
    Eigen::Vector2d firstPx = Eigen::Vector2d::Zero(), stepPx = Eigen::Vector2d::Ones(); ///< luma pixels
};

/// The samples in which robots are searched. Pure.
BitMask searchedSamples(const SearchedArea &area, const SampleLattice &lattice);

/// Whether something of a set is beside a sample of the frame that is not searched, and may go on there.
/// offset: of the set's first sample in the frame. Pure.
bool isCutBy(const BitMask &searched, const BitMask &set, int offsetX, int offsetY);

} // namespace odo
