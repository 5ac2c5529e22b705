// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/lens_fit.h"

#include <vector>

namespace odo {

/// An image that does not belong to the others, and why.
struct OddImage
{
    std::size_t view; ///< index
    Message reason;   ///< a clause
};

/// The images of another camera, zoom or focus than most: their own focal length contradicts that of the
/// others, by a fit (of the starts' model that fits best) that heeds them little and is repeated without them
/// until nothing changes. Besides those whose corners are nowhere near where the others predict them.
/// Ascending; empty where two fifths or more would be odd, for then there is no majority. Where all fit
/// alike, the starts become their fits.
std::vector<OddImage> oddImages(const std::vector<BoardView> &views, std::vector<LensStart> &starts,
                                const JobControl &control);

} // namespace odo
