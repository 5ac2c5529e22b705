// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/lens_fit.h"

#include <array>

namespace odo {

/// Under so many views halves say nothing.
constexpr std::size_t leastViewsForHalves = 6;

/// Each half of the pictures (every other one) under the lens of the other half; only the poses may adapt.
struct HeldOut
{
    double rmsPx = 0;                       ///< over the corners of the pictures that can be foretold
    std::size_t unforetold = 0;             ///< pictures that the other half's lens finds no pose for
    std::vector<double> pictureMeanSquares; ///< px², one a picture; infinite where it is not foretold
    std::array<Intrinsics, 2> lenses;       ///< of the even and of the odd pictures
    double focalDifference() const;         ///< relative
};

/// all: the fit to all views, from which the halves are started. nullopt under six views, where a half led nowhere, and
/// when cancelled.
std::optional<HeldOut> holdOut(const std::vector<BoardView> &views, const LensFit &all, const JobControl &control);

} // namespace odo
