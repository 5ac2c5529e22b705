// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/calibration/accuracy_map.h"

namespace odo {

/// Where a camera may stand.
struct PlaceSearch
{
    double reachM = 2;          ///< so far beyond the rectangle about the markers
    bool aboveTheFloor = false; ///< also within that rectangle, as under a ceiling
    double robotHeightM = 0;    ///< of the plane that counts
    double sigmaPx = 0.1;       ///< of what is followed, as accuracyMap takes it
};

/// The place and aim for one more camera of the height and lens given, so that with the others the most of the floor among
/// the markers is seen and, of those that see as much, the worst place is known best. Looks on a grid of places, each with
/// three aims, then about the best ones ever finer. Some hundred milliseconds; any thread. Errors: no place from which
/// four markers are seen; Cancelled; those of plannedView for the height and the lens.
Result<PlannedCamera> bestPlace(const PlannedCamera &like, const MarkerLayout &layout, std::span<const FloorView> others,
                                const PlaceSearch &search, const JobControl &control);

} // namespace odo
