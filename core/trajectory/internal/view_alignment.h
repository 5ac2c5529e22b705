// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/internal/fused_track.h"

#include <vector>

namespace odo {

/// Where one view alone carries the track, shifts its position by what it was beside the fused track shortly
/// before and after (linear in time between the two). The views' calibrations differ by some millimetres;
/// without this the track would jump by them whenever a view loses or finds the robot, which differences turn
/// into speed. But an error of a calibration changes over the floor: where the view's covariances are known,
/// of what was found at q there counts C(p,q)·C(q,q)⁻¹ at p, the best linear prediction (C: the view's
/// sharedCovariance). Averages over about ten samples with several views; a view that was never together with
/// another is left as it is. Where what was found changes more than the noise of single frames explains, the
/// covariance grows by it. sightings: those the track was fused from; views: as long.
void alignSingleViews(FusedTrack &track, const std::vector<std::vector<Sighting>> &sightings,
                      const std::vector<ViewTrack> &views);

/// A view's sightings at other times (in order): cubic between four neighbours, linear where only two are
/// there; nothing outside, and nothing across more than 2.5 of the view's usual frame intervals. A sighting
/// within 50 µs of the requested time is used as it is. Covariance: the neighbours' own, weighted linearly.
/// The noise of interpolated points is correlated from one to the next, so stating the smaller variance of
/// each single one would let the smoother average away noise that stays. Where the view has fewer frames than
/// are asked for, it is widened by the ratio, for the same reason.
std::vector<Sighting> sightingsAt(const std::vector<Nanoseconds> &times,
                                  const std::vector<Sighting> &sightings);

} // namespace odo
