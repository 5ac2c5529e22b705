// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/fused_track.h"

#include <vector>

namespace odo {

/// Where one view alone carries the track, shifts its position by what it was beside the fused track shortly
/// before and after (linear in time between the two). The views' calibrations differ by some millimetres;
/// without this the track would jump by them whenever a view loses or finds the robot, which differences turn
/// into speed. Averages over about ten samples with several views; a view that was never together with
/// another is left as it is. views: the sightings the track was fused from. Covariances stay those of the
/// single view.
void alignSingleViews(FusedTrack &track, const std::vector<std::vector<Sighting>> &views);

} // namespace odo
