// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

namespace odo {

/// The colours of a raw sensor's top-left 2×2 cell: its first row, then its second.
enum class BayerOrder { Rggb, Grbg, Gbrg, Bggr };

/// Planes of a raw Bayer picture without guessing the missing colours: luma at full size, U and V once a 2×2
/// cell; full range, BT.601, siting Center.
///
/// Luma is the raw picture smoothed by (1 2 1)/4 both ways, which takes the colours' pattern out wherever it
/// lies and leaves R/4 + G/2 + B/4 at its place (Alleysson, Süsstrunk and Hérault 2005, "Linear demosaicing
/// inspired by the human visual system", eq. 5), plus what BT.601 weighs otherwise, from the colour
/// differences of the cells around. These are taken from the 4×4 pixels about the middle of a cell, weighed
/// (1 3 3 1)/8 both ways: of each colour alone these weights have their centre there and the same spread, so
/// that red, green and blue of an edge lie in one place. Beyond the border the picture is mirrored at its
/// outermost pixels, which keeps the colours' order.
///
/// raw: at least 2×2, any stride. Any thread.
Frame bayerPlanes(const PlaneView &raw, BayerOrder order, std::int64_t index, Nanoseconds time);

} // namespace odo
