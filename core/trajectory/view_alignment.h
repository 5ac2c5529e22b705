// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/fused_track.h"

#include <vector>

namespace odo {

/// Where one view alone carries the track, shifts its position by what it was beside the fused track shortly
/// before and after (linear in time between the two). The views' calibrations differ by some millimetres;
/// without this the track would jump by them whenever a view loses or finds the robot, which differences turn
/// into speed. But an error of a calibration changes over the floor: where the view's covariances are known, of
/// what was found at q there counts C(p,q)·C(q,q)⁻¹ at p, the best linear prediction (C: the view's
/// sharedCovariance). Averages over about ten samples with several views; a view that was never together with
/// another is left as it is. sightings: those the track was fused from; views: as long. Covariances stay those
/// of the single view.
void alignSingleViews(FusedTrack &track, const std::vector<std::vector<Sighting>> &sightings,
                      const std::vector<ViewTrack> &views);

} // namespace odo
